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

/// Where progress is reported; both may be empty.
struct Progress {
  std::function<void(const StepReport&)> step;
  std::function<void(const LevelRecord&)> level;
};

/// Puts the problem's bodies in the order of the mesh's.
/// @throws std::invalid_argument if a body of the mesh has no material, or a material no body
void order_bodies(Problem& problem, const mesh::MeshData& mesh);

/// Checks that every name in the problem is in the mesh and that every body is held or touched.
/// @throws std::invalid_argument naming what is missing and what there is
void check(const Problem& problem, const mesh::MeshData& mesh);

/// Solves frictionless contact by nested iteration: solve, estimate, refine, until the peak contact
/// pressure is as accurate as asked.
/// @param mesh coarse mesh, SI units, the same on all ranks
/// @return the last converged state; `outcome` tells whether the accuracy was reached
/// @throws std::invalid_argument where check() does
/// @throws NotConverged if not even the first mesh gave a state
Solution solve_contact(MPI_Comm communicator, const mesh::MeshData& mesh, const Problem& problem,
                       const Settings& settings, const Progress& progress);

}  // namespace geneva::fem
