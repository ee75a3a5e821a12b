#pragma once

#include <mpi.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace geneva::fem {

/// Where the vectors of the ranks stand one behind the other.
struct Gathering {
  std::vector<int> sizes;
  std::vector<int> begins;  ///< and the end

  Gathering(const MPI_Comm communicator, const std::size_t own_size) {
    int ranks = 0;
    MPI_Comm_size(communicator, &ranks);
    sizes.resize(static_cast<std::size_t>(ranks));
    const int own = static_cast<int>(own_size);
    MPI_Allgather(&own, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
    begins.assign(sizes.size() + 1, 0);
    std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(begins.back()); }
};

/// Calls task(type) with the MPI type of a trivially copyable one.
template <typename T, typename Task>
void with_type_of(const Task& task) {
  static_assert(std::is_trivially_copyable_v<T>, "elements travel byte by byte");
  MPI_Datatype element = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &element);
  MPI_Type_commit(&element);
  task(element);
  MPI_Type_free(&element);
}

/// The vectors of all ranks one behind the other in their order, the same on every rank.
///
/// They travel as they are: to compress them first, as the library's all_gather does, takes longer,
/// and is not safe where memory runs out.
template <typename T>
std::vector<T> gathered(const MPI_Comm communicator, const std::vector<T>& own) {
  const Gathering all(communicator, own.size());
  std::vector<T> result(all.size());
  with_type_of<T>([&](const MPI_Datatype element) {
    MPI_Allgatherv(own.data(), static_cast<int>(own.size()), element, result.data(),
                   all.sizes.data(), all.begins.data(), element, communicator);
  });
  return result;
}

/// Those on the first rank; nothing on the others.
template <typename T>
std::vector<T> gathered_on_first(const MPI_Comm communicator, const std::vector<T>& own) {
  const Gathering all(communicator, own.size());
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::vector<T> result(rank == 0 ? all.size() : 0);
  with_type_of<T>([&](const MPI_Datatype element) {
    MPI_Gatherv(own.data(), static_cast<int>(own.size()), element, result.data(), all.sizes.data(),
                all.begins.data(), element, 0, communicator);
  });
  return result;
}

/// One element of every rank, in their order.
template <typename T>
std::vector<T> gathered_one(const MPI_Comm communicator, const T& own) {
  return gathered(communicator, std::vector<T>{own});
}

/// The text of every rank, in their order.
inline std::vector<std::string> gathered_texts(const MPI_Comm communicator,
                                               const std::string& own) {
  const std::vector<char> letters =
      gathered(communicator, std::vector<char>(own.begin(), own.end()));
  std::vector<std::string> texts;
  auto begin = letters.begin();
  for (const std::size_t size : gathered_one(communicator, own.size())) {
    texts.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(size));
    begin += static_cast<std::ptrdiff_t>(size);
  }
  return texts;
}

/// The text of one rank, on every rank.
inline std::string text_of(const MPI_Comm communicator, const unsigned int rank, std::string text) {
  using Block = std::array<char, 64>;  // MPI counts elements in an int
  std::size_t size = text.size();
  const int root = static_cast<int>(rank);
  MPI_Bcast(&size, sizeof(size), MPI_BYTE, root, communicator);
  const std::size_t blocks = (size + sizeof(Block) - 1) / sizeof(Block);
  text.resize(blocks * sizeof(Block));
  with_type_of<Block>([&](const MPI_Datatype block) {
    MPI_Bcast(text.data(), static_cast<int>(blocks), block, root, communicator);
  });
  text.resize(size);
  return text;
}

}  // namespace geneva::fem
