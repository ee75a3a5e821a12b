#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/solver_control.h>

#include <memory>
#include <optional>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/elasticity/cell_systems.h"
#include "fem/linear/constraints.h"
#include "fem/linear/frictional_matrix.h"
#include "fem/linear/multigrid/condensed_matrix.h"
#include "fem/linear/multigrid/preconditioner.h"

namespace geneva::fem {

/// A force on one unknown.
struct NodalForce {
  dealii::types::global_dof_index dof;
  double value;
};

/// What the conjugate gradients are preconditioned with.
enum class Method {
  multigrid,         ///< ours
  factors,           ///< of the whole matrix
  library_multigrid  ///< Trilinos' ML
};

/// Condensed stiffness system K u = f on one mesh: symmetric and positive definite without
/// friction. It is assembled with the constraints that hold for all active sets; those of one
/// active set are eliminated.
template <int dim>
class LinearSystem {
 public:
  /// Assembles the system.
  /// @param ghosts dofs that this rank may write to: locally relevant dofs and all boundary dofs
  /// @param cells of this rank
  LinearSystem(const dealii::DoFHandler<dim>& dof_handler, const dealii::IndexSet& ghosts,
               const dealii::AffineConstraints<double>& constraints, const CellSystems& cells,
               const std::vector<NodalForce>& nodal_forces);

  /// Goes over to other constraints. Our multigrid keeps its coarse levels.
  /// @param constraints those that the system was assembled with, and more of unknowns that they
  /// leave free
  void constrain(const SystemConstraints& constraints);

  /// Sets up a preconditioner for the constraints of now.
  void set_up(const dealii::DoFHandler<dim>& dof_handler, Method method);

  /// Smooths by a few conjugate gradients without a preconditioner that was set up.
  /// @param displacement as in solve()
  /// @return number of iterations
  unsigned int smooth(Vector& displacement) const;

  /// Preconditioned conjugate gradients, with friction generalised minimum residuals, from the
  /// given first guess until the residual is below tolerance times the load, below reduction times
  /// that of the first guess, or what roundings leave of it.
  /// @param displacement in: first guess; out: solution, with the constraints distributed (no
  /// ghosts)
  /// @return number of iterations
  /// @throws dealii::SolverControl::NoConvergence after 1000 iterations, or if the matrix is not
  /// positive definite
  unsigned int solve(Vector& displacement, double tolerance, double reduction) const;

 private:
  void distribute(Vector& displacement) const;
  /// Residual that roundings leave: a stiff body on a soft one is displaced by far more than it is
  /// strained.
  /// @param diagonal of the matrix
  [[nodiscard]] double rounding(const Vector& displacement,
                                const std::vector<double>& diagonal) const;
  [[nodiscard]] double residual_norm(const Vector& displacement) const;

  dealii::IndexSet owned_;
  MPI_Comm communicator_;
  dealii::AffineConstraints<double> lasting_constraints_;  ///< those of all active sets
  dealii::AffineConstraints<double> constraints_;
  Vector whole_load_;  ///< before unknowns are eliminated
  CondensedMatrix<dim> matrix_;
  std::optional<FrictionalMatrix<dim>> frictional_;  ///< where virtual displacements are others
  Vector load_;
  Vector zero_with_ghosts_;  ///< copies of it need no communication, new vectors do
  std::unique_ptr<Preconditioner> preconditioner_;
};

}  // namespace geneva::fem
