#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "fem/discretisation/gather.h"

namespace geneva::api {

/// Objects that Boost serializes, of all ranks in their order, on the first one; nothing on the
/// others. They travel as they are: the library's gather compresses even what stays on its rank.
template <typename Object>
std::vector<Object> gathered_objects(const MPI_Comm communicator, Object own) {
  std::vector<Object> objects;
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) {
    objects.push_back(std::move(own));
    return objects;
  }
  using Block = std::array<char, 64>;  // MPI counts elements in an int
  const std::vector<char> bytes = dealii::Utilities::pack(own, false);
  std::vector<Block> blocks((bytes.size() + sizeof(Block) - 1) / sizeof(Block));
  if (!bytes.empty()) std::memcpy(blocks.data(), bytes.data(), bytes.size());
  const std::vector<std::size_t> sizes = fem::gathered_one(communicator, bytes.size());
  const std::vector<Block> all = fem::gathered_on_first(communicator, blocks);
  if (all.empty()) return objects;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    std::vector<char> of_rank(size);
    std::memcpy(of_rank.data(), &all[first], size);
    objects.push_back(dealii::Utilities::unpack<Object>(of_rank, false));
    first += (size + sizeof(Block) - 1) / sizeof(Block);
  }
  return objects;
}

}  // namespace geneva::api
