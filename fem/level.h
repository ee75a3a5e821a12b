#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "fem/contact/active_set.h"
#include "fem/contact_problem.h"
#include "fem/elasticity.h"
#include "fem/linear_system.h"

namespace geneva::fem {

/// Where arc lengths are counted from, for both surfaces of every pair, on every mesh.
struct SurfaceOrigins {
  std::vector<dealii::Point<2>> source;
  std::vector<dealii::Point<2>> target;
};

/// Everything that belongs to one mesh of the nested iteration, in the units of the triangulation.
struct Level {
  dealii::IndexSet owned;
  dealii::IndexSet ghosts;  ///< locally relevant dofs and all boundary dofs
  Boundary<2> boundary;
  std::vector<ContactInterface<2>> interfaces;
  std::vector<CellSystem> cells;
  std::vector<ConstraintLine> held_lines;  ///< supports and ties
  std::set<global_dof_index> held;         ///< dofs of those lines
  std::vector<NodalForce> tie_forces;
  dealii::AffineConstraints<double> hanging;
  double cell_seconds = 0.;  ///< time to integrate the cells
};

/// Builds the level on the dof handler's mesh.
/// @param origins chosen on the first mesh if empty, kept on the others
Level make_level(const dealii::DoFHandler<2>& dof_handler, const mesh::MeshData<2>& mesh,
                 const Problem<2>& scaled_problem, const Scales& scales,
                 std::optional<SurfaceOrigins>& origins);

/// Converged state on one level.
struct LevelState {
  dealii::TrilinosWrappers::MPI::Vector displacement;  ///< ghosted
  dealii::TrilinosWrappers::MPI::Vector residual;      ///< K u - f, ghosted
  std::vector<ContactState> contacts;                  ///< by interface
  std::vector<unsigned int> linear_iterations;         ///< by active-set step
  double assemble_and_solve_seconds = 0.;              ///< of the first step
  bool cycled = false;  ///< the active set came back to an earlier one
};

/// Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2003); level.interfaces hold
/// the first guess of the active sets and then the final ones.
/// @param guess displacement to start from, without ghosts
/// @return nothing if the active set did not settle within the allowed steps
std::optional<LevelState> solve_level(
    const dealii::DoFHandler<2>& dof_handler, Level& level,
    const dealii::TrilinosWrappers::MPI::Vector& guess, const Settings& settings,
    const std::function<void(unsigned int step, unsigned int iterations)>& report);

}  // namespace geneva::fem
