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

/// Where arc lengths are counted from, for both surfaces of every pair, on every mesh; not used in
/// space.
template <int dim>
struct SurfaceOrigins {
  std::vector<dealii::Point<dim>> source;
  std::vector<dealii::Point<dim>> target;
};

/// Everything that belongs to one mesh of the nested iteration, in the units of the triangulation.
template <int dim>
struct Level {
  dealii::IndexSet owned;
  dealii::IndexSet ghosts;  ///< locally relevant dofs and all boundary dofs
  Boundary<dim> boundary;
  std::vector<ContactInterface<dim>> interfaces;
  std::vector<CellSystem> cells;
  std::vector<ConstraintLine> hanging_lines;  ///< of boundary dofs
  std::vector<ConstraintLine> held_lines;     ///< supports and ties
  std::set<global_dof_index> held;            ///< dofs of those lines
  std::vector<NodalForce> tie_forces;
  dealii::AffineConstraints<double> hanging;
  double cell_seconds = 0.;  ///< time to integrate the cells
};

/// Builds the level on the dof handler's mesh.
/// @param origins chosen on the first mesh if empty, kept on the others
template <int dim>
Level<dim> make_level(const dealii::DoFHandler<dim>& dof_handler, const mesh::MeshData<dim>& mesh,
                      const Problem<dim>& scaled_problem, const Scales& scales,
                      std::optional<SurfaceOrigins<dim>>& origins);

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
template <int dim>
std::optional<LevelState> solve_level(
    const dealii::DoFHandler<dim>& dof_handler, Level<dim>& level,
    const dealii::TrilinosWrappers::MPI::Vector& guess, const Settings& settings,
    const std::function<void(unsigned int step, unsigned int iterations)>& report);

}  // namespace geneva::fem
