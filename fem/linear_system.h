#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <vector>

#include "fem/elasticity.h"

namespace geneva::fem {

/// A force on one unknown.
struct NodalForce {
  dealii::types::global_dof_index dof;
  double value;
};

/// Condensed stiffness system K u = f on one mesh with one set of constraints: symmetric and
/// positive definite.
class LinearSystem {
 public:
  /// Assembles the system and sets up algebraic multigrid, or takes over that of a system that
  /// differs by a few constraints.
  /// @param similar the system whose multigrid is taken over; none: a new one is set up
  /// @param ghosts dofs that this rank may write to: locally relevant dofs and all boundary dofs
  template <int dim>
  LinearSystem(const dealii::DoFHandler<dim>& dof_handler, const dealii::IndexSet& ghosts,
               const dealii::AffineConstraints<double>& constraints,
               const std::vector<CellSystem>& cells, const std::vector<NodalForce>& nodal_forces,
               const LinearSystem* similar);

  /// Sets up the system's own algebraic multigrid, if it has taken over another's.
  template <int dim>
  void set_up_multigrid(const dealii::DoFHandler<dim>& dof_handler);

  /// Conjugate gradients from the given first guess until the residual is below tolerance times the
  /// load, or below reduction times that of the first guess.
  /// @param displacement in: first guess; out: solution, with the constraints distributed (no
  /// ghosts)
  /// @return number of iterations
  /// @throws dealii::SolverControl::NoConvergence after 1000 iterations
  unsigned int solve(dealii::TrilinosWrappers::MPI::Vector& displacement, double tolerance,
                     double reduction) const;

 private:
  dealii::AffineConstraints<double> constraints_;
  std::shared_ptr<dealii::TrilinosWrappers::SparseMatrix> matrix_;
  dealii::TrilinosWrappers::MPI::Vector load_;
  std::shared_ptr<dealii::TrilinosWrappers::SparseMatrix>
      multigrid_matrix_;  ///< outlives multigrid_
  std::shared_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid_;
};

}  // namespace geneva::fem
