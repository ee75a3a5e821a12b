#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <memory>

#include "fem/boundary_tractions.h"
#include "fem/discretisation/vector.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// Stress at the nodes [Pa], continuous within each body, in the order of StressVector.
template <int dim>
struct NodalStress {
  std::unique_ptr<dealii::FESystem<dim>> element;
  std::unique_ptr<dealii::DoFHandler<dim>> dof_handler;
  Vector values;  ///< ghosted
  Vector doubt;   ///< by how much they may be off, as a stress; the same order
};

/// Superconvergent patch recovery (O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer. Meth. Engng 33,
/// 1992) from the stresses in the cells' middles.
///
/// At an inner node it is the value of the linear stress that fits those of the cells around it
/// best; planes of symmetry and axes of revolution count as inner ones, with the cells' images. At
/// other nodes the mean of what the linear stresses of its inner neighbours give there. Where the
/// traction is known and the surface smooth, the strains along the surface are those of the nodes'
/// displacements and the stress on it is the traction (see surface_stress()), which at a support or
/// tie is that of the nodes' forces (see held_tractions()); at an edge or corner that sticks out,
/// what is not along it is zero.
///
/// The doubt is a share of the difference from a poorer recovery: at those surfaces of that from
/// inside alone, elsewhere of the mean of the cells around, whose error is of the first order, so
/// that the share is one in proportion to the relative difference.
/// @param displacement ghosted
template <int dim>
NodalStress<dim> recovered_stress(const dealii::DoFHandler<dim>& dof_handler,
                                  const Vector& displacement, const Problem<dim>& problem,
                                  const BoundaryTractions<dim>& tractions);

}  // namespace geneva::fem
