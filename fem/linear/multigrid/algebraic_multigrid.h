#pragma once

#include <deal.II/base/point.h>

#include <memory>
#include <optional>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/chebyshev.h"
#include "fem/linear/multigrid/direct_solver.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/rigid_displacement.h"

namespace geneva::fem {

/// What a coarse level of a multigrid is made from.
template <int dim>
struct CoarseProblem {
  SymmetricMatrix<n_rigid_motions<dim>> matrix;  ///< positive semi-definite
  std::vector<dealii::Point<dim>> positions;     ///< of this rank's nodes
  std::vector<unsigned int> bodies;              ///< of this rank's nodes
};

/// V-cycles of smoothed aggregation (Vanek, Mandel and Brezina 1996) with the aggregates of
/// aggregate(), for nodes that move rigidly.
template <int dim>
class AlgebraicMultigrid {
 public:
  /// @param most_for_factors levels with so many unknowns at most are factorised
  AlgebraicMultigrid(CoarseProblem<dim> problem, int most_for_factors, MPI_Comm communicator);

  void vmult(Vector& correction, const Vector& residual) const;

 private:
  static constexpr int n = n_rigid_motions<dim>;

  std::optional<SymmetricMatrix<n>> matrix_;
  std::unique_ptr<DirectSolver<n>> direct_;  ///< of the coarsest level, which has nothing else
  std::unique_ptr<Chebyshev<SymmetricMatrix<n>>> smoother_;
  std::optional<NodeMatrix<n, n>> prolongation_;
  std::unique_ptr<AlgebraicMultigrid> coarse_;
  Vector coarse_zero_;  ///< as v_cycle() takes it
};

}  // namespace geneva::fem
