#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include "fem/linear/multigrid/coupled_nodes.h"
#include "fem/linear/multigrid/elimination.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/rigid_displacement.h"

namespace geneva::fem {

/// How the unknowns of a mesh depend on each other.
struct Dependence {
  const dealii::AffineConstraints<double>& constraints;  ///< by which the matrix was assembled
  const Elimination& elimination;                        ///< of constrained unknowns
  const dealii::IndexSet& unknowns;                      ///< of this rank
};

/// The first coarsening: coarse nodes move rigidly, each with three or six unknowns, its
/// displacement and its rotation.
template <int dim>
struct Prolongation {
  NodeMatrix<dim, n_rigid_motions<dim>> matrix;  ///< fine by coarse unknowns
  std::vector<unsigned int> bodies;              ///< of this rank's coarse nodes
  std::vector<dealii::Point<dim>> positions;     ///< of this rank's coarse nodes
};

/// Smoothed aggregation (Vanek, Mandel and Brezina 1996) along the short sides of long cells only:
/// what alternates from layer to layer of long cells is soft, no point smoother reduces it, and so
/// it must not be coarsened. One step of Jacobi's method smooths the rigid motions of the
/// aggregates; it is kept to the aggregates next to a node along short sides, and what rigid
/// motions of the whole then lack is given back (Olson, Schroder and Tuminaro 2011).
/// @param nodes of the matrix before unknowns were eliminated
/// @param dependence constrained unknowns get zero rows, eliminated ones what they follow
/// @param diagonal of the matrix after that, by this rank's unknowns
/// @param largest_eigenvalue of the matrix scaled by its diagonal, positive
template <int dim>
Prolongation<dim> prolongation(const CoupledNodes<dim>& nodes, const Dependence& dependence,
                               const std::vector<double>& diagonal, double largest_eigenvalue,
                               MPI_Comm communicator);

}  // namespace geneva::fem
