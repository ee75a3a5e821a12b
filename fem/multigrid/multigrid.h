#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

namespace geneva::fem {

/// One V-cycle (Trottenberg, Oosterlee and Schueller 2001, 2.4): Chebyshev smoothing on the mesh,
/// correction on the coarse nodes of prolongation() by algebraic_multigrid().
class Multigrid : public dealii::TrilinosWrappers::PreconditionBase {
 public:
  /// @param matrix condensed stiffness; must outlive the multigrid
  /// @param constraints by which it is condensed
  template <int dim>
  Multigrid(const dealii::TrilinosWrappers::SparseMatrix& matrix,
            const dealii::DoFHandler<dim>& dof_handler,
            const dealii::AffineConstraints<double>& constraints);

  void vmult(dealii::TrilinosWrappers::MPI::Vector& correction,
             const dealii::TrilinosWrappers::MPI::Vector& residual) const override;

 private:
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  const Matrix& matrix_;
  std::unique_ptr<Matrix> prolongation_;
  std::unique_ptr<Epetra_CrsMatrix> coarse_matrix_;
  std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> coarse_;
  Vector coarse_zero_;  ///< copies of it need no communication, new vectors do
  dealii::TrilinosWrappers::PreconditionChebyshev first_smoother_;  ///< from zero
  dealii::TrilinosWrappers::PreconditionChebyshev smoother_;
};

}  // namespace geneva::fem
