#include "fem/multigrid/multigrid.h"

#include <algorithm>
#include <vector>

#include "fem/multigrid/algebraic_multigrid.h"
#include "fem/multigrid/coarse_matrix.h"
#include "fem/multigrid/prolongation.h"
#include "fem/multigrid/rigid_displacement.h"

namespace geneva::fem {

namespace {

/// Makes the matrix positive definite where aggregates lack rigid motions: those whose nodes stand
/// in a line do not turn about it, nor do nodes of a plane of symmetry leave it.
void complete(Epetra_CrsMatrix& matrix, std::vector<double>& rigid_motions) {
  // Above the roundings, and far below what the iterations of the mesh could notice: what it
  // completes does not move the mesh.
  constexpr double shift = 1e-10;
  const int n_rows = matrix.NumMyRows();
  for (int row = 0; row < n_rows; ++row) {
    int count = 0;
    double* values = nullptr;
    int* columns = nullptr;
    matrix.ExtractMyRowView(row, count, values, columns);
    double& diagonal = values[std::find(columns, columns + count, row) - columns];
    const bool is_moved = diagonal > 0.;
    diagonal = is_moved ? (1. + shift) * diagonal : 1.;
    if (is_moved) continue;
    for (auto i = static_cast<std::size_t>(row); i < rigid_motions.size();
         i += static_cast<std::size_t>(n_rows))
      rigid_motions[i] = 0.;
  }
}

}  // namespace

template <int dim>
Multigrid<dim>::Multigrid(const NodeMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler,
                          const dealii::AffineConstraints<double>& constraints)
    : matrix_(matrix) {
  // The power method comes from below, and Chebyshev's polynomial grows fast beyond its range.
  constexpr double margin = 1.1;
  // Of the eigenvalues that are smoothed, as on the algebraic levels; 6 and 20 take an iteration
  // more.
  constexpr double ratio = 10.;
  const MPI_Comm communicator = dof_handler.get_communicator();
  const double largest = margin * largest_eigenvalue(matrix, communicator);
  const CoupledNodes<dim> nodes(matrix, dof_handler);
  Prolongation prolonged =
      prolongation(nodes, dof_handler.locally_owned_dofs(), constraints, largest, communicator);
  prolongation_ = std::move(prolonged.matrix);
  coarse_matrix_ = coarse_matrix(nodes, *prolongation_);
  complete(*coarse_matrix_, prolonged.rigid_motions);
  coarse_ = algebraic_multigrid(*coarse_matrix_, n_rigid_motions<dim>, prolonged.rigid_motions,
                                prolonged.bodies);
  coarse_zero_.reinit(prolongation_->locally_owned_domain_indices(), communicator);
  smoother_ = std::make_unique<Chebyshev<dim>>(matrix, largest / ratio, margin * largest);
}

template <int dim>
void Multigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  smoother_->solve(correction, residual);
  Vector rest(residual);
  matrix_.residual(rest, correction, residual);
  Vector coarse_residual(coarse_zero_);
  prolongation_->Tvmult(coarse_residual, rest);
  Vector coarse_correction(coarse_residual);
  coarse_->vmult(coarse_correction, coarse_residual);
  prolongation_->vmult_add(correction, coarse_correction);
  smoother_->improve(correction, residual);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace geneva::fem
