#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <optional>
#include <vector>

#include "fem/linear/multigrid/algebraic_multigrid.h"
#include "fem/linear/multigrid/chebyshev.h"
#include "fem/linear/multigrid/condensed_matrix.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/preconditioner.h"

namespace geneva::fem {

/// One V-cycle: smoothing on the mesh with the matrix as it is, correction on the coarse nodes of
/// prolongation() by AlgebraicMultigrid for the matrix as it was when the multigrid was made. Or
/// the mesh is the coarsest level itself: then its matrix is factorised.
template <int dim>
class Multigrid : public Preconditioner {
 public:
  /// @param matrix condensed stiffness; must outlive the multigrid
  /// @param constraints by which the whole matrix was assembled
  /// @param is_factorised whether the mesh is the coarsest level, see is_factorised()
  Multigrid(const CondensedMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler,
            const dealii::AffineConstraints<double>& constraints, bool is_factorised);

  void vmult(Vector& correction, const Vector& residual) const override;
  void renew() override;

  /// The maximum eigenvalue of the matrix, scaled by its diagonal, for which the smoother is made.
  [[nodiscard]] double maximum_smoothed() const;

  [[nodiscard]] bool is_definite() const override { return !direct_ || direct_->is_definite(); }

 private:
  void make_levels(const dealii::DoFHandler<dim>& dof_handler,
                   const dealii::AffineConstraints<double>& constraints);
  void factorise();
  void make_smoother();
  void renew_eigenvalue();

  const CondensedMatrix<dim>& matrix_;
  MPI_Comm communicator_;
  bool is_factorised_;
  std::unique_ptr<DirectSolver<dim>> direct_;  ///< of a mesh that has nothing else
  double largest_eigenvalue_ = 0.;             ///< of the matrix scaled by its diagonal, from above
  Vector eigenvector_;                         ///< near that of it
  std::vector<double> diagonal_;               ///< of the matrix whose eigenvalue it is
  std::optional<NodeMatrix<dim, n_rigid_motions<dim>>> prolongation_;
  std::unique_ptr<AlgebraicMultigrid<dim>> coarse_;
  Vector coarse_zero_;  ///< as v_cycle() takes it
  std::unique_ptr<Chebyshev<CondensedMatrix<dim>>> smoother_;
};

}  // namespace geneva::fem
