#pragma once

#include <mpi.h>

#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace geneva::fem {

/// The vectors of all ranks one behind the other in their order, the same on every rank.
///
/// They travel as they are: to compress them first, as the library's all_gather does, takes longer,
/// and is not safe where memory runs out.
template <typename T>
std::vector<T> gathered(const MPI_Comm communicator, const std::vector<T>& own) {
  static_assert(std::is_trivially_copyable_v<T>, "elements travel byte by byte");
  int ranks = 0;
  MPI_Comm_size(communicator, &ranks);
  const int own_size = static_cast<int>(own.size());
  std::vector<int> sizes(static_cast<std::size_t>(ranks));
  MPI_Allgather(&own_size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
  std::vector<int> begins(sizes.size() + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
  std::vector<T> all(static_cast<std::size_t>(begins.back()));
  MPI_Datatype element = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &element);
  MPI_Type_commit(&element);
  MPI_Allgatherv(own.data(), own_size, element, all.data(), sizes.data(), begins.data(), element,
                 communicator);
  MPI_Type_free(&element);
  return all;
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

}  // namespace geneva::fem
