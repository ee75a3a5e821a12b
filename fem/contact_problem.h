#pragma once

#include <mpi.h>

#include <functional>
#include <stdexcept>

#include "fem/problem.h"
#include "fem/solution.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// The contact solve could not reach a state on any mesh: the message says what happened and what
/// to try.
class NotConverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Told after every active-set step, on every rank: refinement level, unknowns, step and its linear
/// iterations.
struct StepReport {
  unsigned int level;
  unsigned int dofs;
  unsigned int step;
  unsigned int linear_iterations;
};

/// Where progress is reported, on every rank; each may be empty.
template <int dim>
struct Progress {
  std::function<void(const StepReport&)> step;
  std::function<void(const LevelRecord&)> level;
  /// After every mesh, the last of whose records is that of `history`.
  std::function<void(const Solution<dim>&)> solution;
};

/// Solves frictionless contact by nested iteration: solve, estimate, refine, until the peak contact
/// pressure is as accurate as asked.
/// @param mesh coarse mesh, SI units, the same on all ranks
/// @return the last converged state; `outcome` tells whether the accuracy was reached
/// @throws base::InputError where check() and check_rigid_motions() do, and if the load opens
/// all contact
/// @throws NotConverged if not even the first mesh gave a state
template <int dim>
Solution<dim> solve_contact(MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                            const Problem<dim>& problem, const Settings& settings,
                            const Progress<dim>& progress);

}  // namespace geneva::fem
