#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <optional>

#include "fem/multigrid/algebraic_multigrid.h"
#include "fem/multigrid/chebyshev.h"
#include "fem/multigrid/condensed_matrix.h"
#include "fem/multigrid/node_matrix.h"

namespace geneva::fem {

/// One V-cycle: smoothing on the mesh with the matrix as it is, correction on the coarse nodes of
/// prolongation() by AlgebraicMultigrid for the matrix as it was when the multigrid was made.
template <int dim>
class Multigrid {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param matrix condensed stiffness; must outlive the multigrid
  /// @param constraints by which the whole matrix was assembled
  Multigrid(const CondensedMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler,
            const dealii::AffineConstraints<double>& constraints);

  void vmult(Vector& correction, const Vector& residual) const;

  /// To be called when other unknowns of the matrix follow others.
  void renew_smoother();

 private:
  const CondensedMatrix<dim>& matrix_;
  double largest_eigenvalue_;  ///< of the matrix scaled by its diagonal, from above
  std::optional<NodeMatrix<dim, n_rigid_motions<dim>>> prolongation_;
  std::unique_ptr<AlgebraicMultigrid<dim>> coarse_;
  Vector coarse_zero_;  ///< as v_cycle() takes it
  std::unique_ptr<Chebyshev<CondensedMatrix<dim>>> smoother_;
};

}  // namespace geneva::fem
