#include "fem/multigrid/multigrid.h"

#include <algorithm>
#include <cmath>

#include "fem/multigrid/algebraic_multigrid.h"
#include "fem/multigrid/coarse_matrix.h"
#include "fem/multigrid/prolongation.h"
#include "fem/multigrid/rigid_displacement.h"

namespace geneva::fem {

namespace {

using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// Largest eigenvalue of the matrix scaled by its diagonal, a little too large: by the power method
/// from a vector that is the same in every run.
double largest_eigenvalue(const Matrix& matrix) {
  constexpr int n_steps = 12;
  // The power method comes from below, and Chebyshev's polynomial grows fast beyond its range.
  constexpr double margin = 1.1;
  Vector vector(matrix.locally_owned_range_indices(), matrix.get_mpi_communicator());
  for (const auto row : vector.locally_owned_elements())
    vector(row) = std::sin(static_cast<double>(row * row % 7919));
  vector.compress(dealii::VectorOperation::insert);
  dealii::TrilinosWrappers::PreconditionJacobi jacobi;
  jacobi.initialize(matrix);
  Vector product(vector);
  for (int step = 0; step < n_steps; ++step) {
    vector /= vector.l2_norm();
    matrix.vmult(product, vector);
    jacobi.vmult(vector, product);
  }
  return margin * vector.l2_norm();
}

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
Multigrid::Multigrid(const Matrix& matrix, const dealii::DoFHandler<dim>& dof_handler,
                     const dealii::AffineConstraints<double>& constraints)
    : matrix_(matrix) {
  constexpr unsigned int degree = 2;
  // Of the eigenvalues that are smoothed, as on the algebraic levels; 6 and 20 take an iteration
  // more.
  constexpr double ratio = 10.;
  const double largest = largest_eigenvalue(matrix);
  const CoupledNodes<dim> nodes(matrix, dof_handler);
  Prolongation prolonged = prolongation(nodes, dof_handler.locally_owned_dofs(), constraints,
                                        largest, dof_handler.get_communicator());
  prolongation_ = std::move(prolonged.matrix);
  coarse_matrix_ = coarse_matrix(nodes, *prolongation_);
  complete(*coarse_matrix_, prolonged.rigid_motions);
  coarse_ = algebraic_multigrid(*coarse_matrix_, n_rigid_motions<dim>, prolonged.rigid_motions,
                                prolonged.bodies);
  coarse_zero_.reinit(prolongation_->locally_owned_domain_indices(), matrix.get_mpi_communicator());
  first_smoother_.initialize(matrix, {degree, largest, ratio, 1., 1e-12, false});
  smoother_.initialize(matrix, {degree, largest, ratio, 1., 1e-12, true});
}

void Multigrid::vmult(Vector& correction, const Vector& residual) const {
  first_smoother_.vmult(correction, residual);
  Vector rest(residual);
  matrix_.residual(rest, correction, residual);
  Vector coarse_residual(coarse_zero_);
  prolongation_->Tvmult(coarse_residual, rest);
  Vector coarse_correction(coarse_residual);
  coarse_->vmult(coarse_correction, coarse_residual);
  prolongation_->vmult_add(correction, coarse_correction);
  smoother_.vmult(correction, residual);
}

template Multigrid::Multigrid(const Matrix&, const dealii::DoFHandler<2>&,
                              const dealii::AffineConstraints<double>&);
template Multigrid::Multigrid(const Matrix&, const dealii::DoFHandler<3>&,
                              const dealii::AffineConstraints<double>&);

}  // namespace geneva::fem
