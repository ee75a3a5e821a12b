#include "app/early_mesher.h"

#include <deal.II/base/mpi.h>

#include "app/launch.h"

namespace geneva::app {

EarlyMesher::EarlyMesher() {
  if (is_launched_as_first_rank()) mesher_.emplace(mesh::installed_mesher());
}

mesh::Mesher* EarlyMesher::on_rank_zero() {
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) return nullptr;
  if (!mesher_) mesher_.emplace(mesh::installed_mesher());
  return &*mesher_;
}

}  // namespace geneva::app
