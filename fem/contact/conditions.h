#pragma once

#include <set>
#include <vector>

#include "fem/contact/interface.h"
#include "fem/discretisation/vector.h"
#include "fem/elasticity/surface_forces.h"
#include "fem/linear/constraints.h"

namespace geneva::fem {

/// What the nodes in contact constrain.
struct ContactLines {
  std::vector<ConstraintLine> displacement;
  /// Of the virtual displacements on which the tractions do no work: of the same unknowns, tilted
  /// by the friction of nodes that slip.
  std::vector<ConstraintLine> virtual_displacement;
  bool are_equal = true;  ///< whether the two are, but for inhomogeneities
};

/// The equations of the pair's law that are constraints, such as gap_j(u) = 0, solved for the
/// displacement component with the maximum share of their direction that no support holds. Those
/// whose components are all held are left out. The traction of a node that slides along d is
/// p (n - mu d), so that virtual displacements have (n - mu d) . (D v_j - sum_k M_jk v_k) = 0
/// (Hueber, Stadler and Wohlmuth 2008).
/// @param held dofs that supports, ties or other contact pairs already constrain; the lines' dofs
/// are added
template <int dim>
ContactLines contact_lines(const ContactInterface<dim>& interface,
                           std::set<global_dof_index>& held);

/// Gap and slip from the displacement; pressure and friction from the forces K u - f, divided by D
/// (no differentiation).
/// @param held dofs whose forces hold reactions of supports
template <int dim>
ContactState evaluate(const ContactInterface<dim>& interface, const Vector& displacement,
                      const SurfaceForces& forces, const std::set<global_dof_index>& held);

}  // namespace geneva::fem
