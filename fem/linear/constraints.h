#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "fem/discretisation/boundary.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// u_dof = sum of coefficient * u_entry + inhomogeneity.
struct ConstraintLine {
  global_dof_index dof;
  std::vector<std::pair<global_dof_index, double>> entries;
  double inhomogeneity;
};

/// The supports as constraint lines, the same on all ranks.
/// @throws base::InputError if two supports prescribe different displacements at one node
template <int dim>
std::vector<ConstraintLine> support_lines(const Boundary<dim>& boundary,
                                          const std::vector<Support<dim>>& supports,
                                          const std::vector<std::string>& surfaces);

/// The constraints of one system, closed.
struct SystemConstraints {
  dealii::AffineConstraints<double> displacement;
  /// Homogeneous, of the same unknowns: where friction acts the virtual displacements on which
  /// tractions do no work are others than the displacements. None: they are the same.
  std::optional<dealii::AffineConstraints<double>> virtual_displacement = std::nullopt;
};

/// A rigid tie's lines, and the unknown that carries its motion and force.
struct TieLines {
  std::vector<ConstraintLine> lines;
  global_dof_index master;
  double master_force;  ///< right-hand side entry of the master: force / (direction's component of
                        ///< the master)
};

template <int dim>
TieLines tie_lines(const Boundary<dim>& boundary, const RigidTie<dim>& tie,
                   const std::vector<std::string>& surfaces);

/// This rank's hanging nodes, open for more lines.
/// @param ghosts the dofs whose lines this rank may need: locally relevant dofs and all boundary
/// dofs
template <int dim>
dealii::AffineConstraints<double> hanging_nodes(const dealii::DoFHandler<dim>& dof_handler,
                                                const dealii::IndexSet& ghosts);

/// The hanging-node lines of all boundary dofs, the same on all ranks: contact lines refer to dofs
/// of bodies that a rank knows nothing else of. In the plane there are none.
/// @param hanging_nodes of this rank
template <int dim>
std::vector<ConstraintLine> hanging_lines(const dealii::DoFHandler<dim>& dof_handler,
                                          const dealii::AffineConstraints<double>& hanging_nodes,
                                          const Boundary<dim>& boundary);

/// This rank's hanging nodes and the given lines, closed.
/// @param hanging_nodes open
dealii::AffineConstraints<double> make_constraints(
    const dealii::AffineConstraints<double>& hanging_nodes,
    const std::vector<ConstraintLine>& lines);

}  // namespace geneva::fem
