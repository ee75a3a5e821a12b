#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "fem/contact/interface.h"
#include "fem/contact_problem.h"
#include "fem/elasticity/cell_systems.h"
#include "fem/elasticity/surface_forces.h"
#include "fem/linear/constraints.h"
#include "fem/linear/linear_system.h"

namespace geneva::fem {

/// Everything that belongs to one mesh of the nested iteration, in the units of the triangulation.
template <int dim>
struct Level {
  dealii::IndexSet owned;
  dealii::IndexSet ghosts;  ///< locally relevant dofs and all boundary dofs
  Boundary<dim> boundary;
  std::vector<ContactInterface<dim>> interfaces;
  CellSystems cells;
  bool is_factorised = false;           ///< see is_factorised()
  bool is_held_by_friction = false;     ///< a body moves freely if nothing sticks
  std::vector<bool> holds_by_friction;  ///< by interface: a body moves freely if it alone slides
  std::vector<bool> holds_by_contact;   ///< by interface: a body moves freely if it alone is open
  std::vector<ConstraintLine> hanging_lines;  ///< of boundary dofs
  std::vector<ConstraintLine> held_lines;     ///< supports and ties
  std::set<global_dof_index> held;            ///< dofs of those lines
  std::vector<NodalForce> tie_forces;
  dealii::AffineConstraints<double> hanging_nodes;  ///< of this rank, open for more lines
  dealii::AffineConstraints<double> hanging;        ///< closed, with all boundary dofs
  ForcedUnknowns forced;                            ///< of contact, supports and ties
};

/// Builds the level on the dof handler's mesh.
/// @param origins chosen on the first mesh if empty, kept on the others
template <int dim>
Level<dim> make_level(const dealii::DoFHandler<dim>& dof_handler, const mesh::MeshData<dim>& mesh,
                      const Problem<dim>& scaled_problem, const Scales& scales,
                      std::optional<SurfaceOrigins<dim>>& origins);

/// Sets what depends on the loads and prescribed displacements of a problem that is otherwise the
/// level's.
template <int dim>
void set_load(Level<dim>& level, const dealii::DoFHandler<dim>& dof_handler,
              const mesh::MeshData<dim>& mesh, const Problem<dim>& scaled_problem);

/// The constraints that hold for all active sets: hanging nodes, supports, ties.
template <int dim>
dealii::AffineConstraints<double> lasting_constraints(const Level<dim>& level);

/// Those, and contact with the level's active sets.
template <int dim>
SystemConstraints constraints(const Level<dim>& level);

}  // namespace geneva::fem
