#pragma once

#include <Epetra_FECrsMatrix.h>

#include <deal.II/dofs/dof_handler.h>
#include <ml_MultiLevelPreconditioner.h>

#include <memory>
#include <vector>

#include "fem/linear/multigrid/condensed_matrix.h"
#include "fem/linear/multigrid/preconditioner.h"

namespace geneva::fem {

/// Smoothed aggregation of Trilinos' ML, which knows the rigid motions, for the matrix E^T A E as
/// it is: another way to the same solution, by which ours can be measured and checked.
template <int dim>
class LibraryMultigrid : public Preconditioner {
 public:
  /// @param matrix must outlive this
  LibraryMultigrid(const CondensedMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler);

  void vmult(Vector& correction, const Vector& residual) const override;
  void renew() override;

 private:
  void fill_matrix();
  /// Rigid motions at this rank's unknowns, one after the other; 0 at the constrained ones.
  [[nodiscard]] std::vector<double> rigid_motions() const;

  const CondensedMatrix<dim>& matrix_;
  std::vector<dealii::Point<dim>> positions_;  ///< of this rank's nodes
  std::unique_ptr<Epetra_FECrsMatrix> condensed_;
  std::vector<double> motions_;  ///< ML keeps no copy
  std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> levels_;
};

}  // namespace geneva::fem
