#pragma once

#include <deal.II/base/mpi.h>

#include <optional>

#include "mesh/mesher.h"
#include "model/together.h"

namespace geneva::api {

/// The mesher of an analysis: the one that it is given, or else one of its own.
class MesherOnRankZero {
 public:
  /// @param given on rank 0; may be nothing
  /// @throws base::InputError on all ranks if one is to be started and cannot be
  MesherOnRankZero(const MPI_Comm communicator, mesh::Mesher* const given) : given_(given) {
    const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    model::together(communicator, [&] {
      if (is_first && given == nullptr) own_.emplace(mesh::installed_mesher());
    });
  }

  /// Nothing on other ranks.
  [[nodiscard]] mesh::Mesher* get() { return own_ ? &*own_ : given_; }

 private:
  mesh::Mesher* given_;
  std::optional<mesh::Mesher> own_;
};

}  // namespace geneva::api
