#pragma once

#include <deal.II/dofs/dof_handler.h>

namespace geneva::fem {

/// Numbers the unknowns of each rank anew, node by node, so that nodes of one cell have numbers
/// close to each other: from a node at an end of its part of the mesh on, neighbours follow
/// neighbours, and the order is turned round (Cuthill and McKee 1969, George 1971; neighbours of a
/// node are not sorted). A product with the stiffness matrix then finds in the cache what it reads
/// of a vector, and aggregates that are begun in this order leave few nodes over.
template <int dim>
void number_by_neighbours(dealii::DoFHandler<dim>& dof_handler);

}  // namespace geneva::fem
