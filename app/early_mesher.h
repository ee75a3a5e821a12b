#pragma once

#include <optional>

#include "mesh/mesher.h"

namespace geneva::app {

/// A mesher that gets ready while MPI does, on the process that the launcher of MPI programs, if
/// there is one, will make the first rank.
class EarlyMesher {
 public:
  /// @throws base::InputError if it cannot be started
  EarlyMesher();

  /// Once MPI knows the ranks: the mesher on rank 0, nothing elsewhere.
  /// @throws base::InputError if it cannot be started
  mesh::Mesher* on_rank_zero();

 private:
  std::optional<mesh::Mesher> mesher_;
};

}  // namespace geneva::app
