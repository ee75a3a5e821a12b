#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <optional>

#include "fem/multigrid/algebraic_multigrid.h"
#include "fem/multigrid/chebyshev.h"
#include "fem/multigrid/corrected_matrix.h"
#include "fem/multigrid/node_matrix.h"

namespace geneva::fem {

/// One V-cycle: smoothing on the mesh with the matrix as it is, correction on the coarse nodes of
/// prolongation() by AlgebraicMultigrid for the matrix without its correction.
template <int dim>
class Multigrid {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param matrix condensed stiffness; must outlive the multigrid
  /// @param constraints by which it is condensed without its correction
  Multigrid(const CorrectedMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler,
            const dealii::AffineConstraints<double>& constraints);

  void vmult(Vector& correction, const Vector& residual) const;

  /// To be called when the matrix has got another correction.
  void renew_smoother();

 private:
  const CorrectedMatrix<dim>& matrix_;
  double largest_eigenvalue_;  ///< of the uncorrected matrix scaled by its diagonal, from above
  std::optional<NodeMatrix<dim, n_rigid_motions<dim>>> prolongation_;
  std::unique_ptr<AlgebraicMultigrid<dim>> coarse_;
  Vector coarse_zero_;  ///< as v_cycle() takes it
  std::unique_ptr<Chebyshev<CorrectedMatrix<dim>>> smoother_;
};

}  // namespace geneva::fem
