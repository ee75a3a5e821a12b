#pragma once

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <optional>

#include "fem/checkpoint.h"
#include "fem/problem/problem.h"
#include "fem/problem/settings.h"
#include "fem/solution.h"
#include "fem/step_report.h"
#include "fem/work_report.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Where progress is reported, on every rank; each may be empty.
template <int dim>
struct Progress {
  std::function<void(const StepReport&)> step;
  std::function<void(const LevelRecord&)> level;
  /// After every mesh, the last of whose records is that of `history`.
  std::function<void(const Solution<dim>&)> solution;
  /// After those; collects the mesh and the displacement.
  std::function<void(const Checkpoint<dim>&)> checkpoint;
  /// Before those, after each load step: the solution as if it were the last one, without strength
  /// and instants; of a mesh without an equilibrium, or left for memory, of the first steps only.
  std::function<void(std::size_t step, const Solution<dim>&)> load_step = {};
  std::function<void(const WorkReport&)> work = {};
};

/// Solves contact by nested iteration: solve, estimate, refine, until the peak contact
/// pressure is as accurate as asked; without contact until the maxima of stress are.
/// @param mesh coarse mesh, SI units, the same on all ranks
/// @param start where an earlier run on this mesh and problem ended, the same on all ranks; the
/// accuracy may be another
/// @return the last converged state; `stop` tells whether the accuracy was reached
/// @throws base::InputError where check() and check_rigid_motions() do, and if the load opens
/// all contact, or `start` does not fit
/// @throws NotConverged if not even the first mesh gave a state, if the coarse mesh is larger than
/// allowed, or if memory runs out and there is no result yet, or there are several ranks
template <int dim>
Solution<dim> solve_contact(MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                            const Problem<dim>& problem, const Settings& settings,
                            const Progress<dim>& progress,
                            const std::optional<Checkpoint<dim>>& start = std::nullopt);

}  // namespace geneva::fem
