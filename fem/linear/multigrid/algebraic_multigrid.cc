#include "fem/linear/multigrid/algebraic_multigrid.h"

#include <algorithm>
#include <utility>

#include "fem/linear/multigrid/aggregation.h"
#include "fem/linear/multigrid/coarse_matrix.h"
#include "fem/linear/multigrid/coarse_nodes.h"
#include "fem/linear/multigrid/v_cycle.h"

namespace geneva::fem {

namespace {

template <int n>
using MotionRow = BlockRow<Eigen::Matrix<double, n, n>>;

/// Makes the matrix positive definite where nodes lack rigid motions: those that stand for nodes in
/// a line do not turn about it, nor do nodes of a plane of symmetry leave it.
/// @return whether each of this rank's unknowns moves
template <int n>
std::vector<bool> complete(SymmetricMatrix<n>& matrix) {
  // Above the roundings, and far below what the iterations of the mesh could notice: what it
  // completes does not move the mesh.
  constexpr double shift = 1e-10;
  std::vector<bool> is_moved;
  for (std::size_t row = 0; row < matrix.pattern().n_rows(); ++row)
    for (int component = 0; component < n; ++component) {
      double& diagonal = matrix.diagonal_block(row)(component, component);
      is_moved.push_back(diagonal > 0.);
      diagonal = is_moved.back() ? (1. + shift) * diagonal : 1.;
    }
  return is_moved;
}

/// Aggregates of this rank's nodes.
template <int n>
Aggregates aggregates_of(const NodePattern& pattern, const std::vector<unsigned int>& bodies) {
  std::vector<std::vector<int>> neighbours(pattern.n_rows());
  for (std::size_t node = 0; node < neighbours.size(); ++node) {
    const std::size_t first = pattern.first_block(node);
    const std::size_t end = pattern.first_block(node + 1);
    for (std::size_t i = first; i < end; ++i) {
      const int other = pattern.place(i);
      if (static_cast<std::size_t>(other) != node &&
          static_cast<std::size_t>(other) < neighbours.size())
        neighbours[node].push_back(other);
    }
    // Coupled to nodes of other ranks alone, it may still begin an aggregate.
    if (neighbours[node].empty() && end - first > 1)
      neighbours[node].push_back(static_cast<int>(node));
  }
  return aggregate(neighbours, bodies, 1);
}

/// The rows of (1 - step D^-1 A) T, where T are the rigid motions of the aggregates.
template <int dim, int n = n_rigid_motions<dim>>
std::vector<MotionRow<n>> smoothed_motions(const SymmetricMatrix<n>& matrix,
                                           const std::vector<dealii::Point<dim>>& positions,
                                           const CoarseNodes<dim>& coarse, const double step) {
  const auto motion = [&](const std::size_t place) {
    return rigid_motion<dim>(positions[place] - coarse.centres[place]);
  };
  std::vector<MotionRow<n>> rows(matrix.pattern().n_rows());
  for (std::size_t node = 0; node < rows.size(); ++node)
    if (coarse.of_nodes[node] != no_aggregate) rows[node].at(coarse.of_nodes[node]) = motion(node);
  matrix.visit_blocks([&](const std::size_t node, const std::size_t other, const auto& block) {
    if (coarse.of_nodes[node] == no_aggregate || coarse.of_nodes[other] == no_aggregate) return;
    const Eigen::Matrix<double, n, 1> steps =
        step * matrix.diagonal_block(node).diagonal().cwiseInverse();
    rows[node].at(coarse.of_nodes[other]).noalias() -= steps.asDiagonal() * (block * motion(other));
  });
  return rows;
}

/// @param is_moved of each of this rank's unknowns
template <int dim, int n = n_rigid_motions<dim>>
NodeMatrix<n, n> smoothed_prolongation(const SymmetricMatrix<n>& matrix,
                                       const std::vector<dealii::Point<dim>>& positions,
                                       const CoarseNodes<dim>& coarse,
                                       const std::vector<bool>& is_moved, const double step) {
  auto rows = smoothed_motions<dim>(matrix, positions, coarse, step);
  for (std::size_t node = 0; node < rows.size(); ++node)
    for (int component = 0; component < n; ++component)
      if (!is_moved[n * node + static_cast<std::size_t>(component)])
        for (auto& block : rows[node].blocks()) block.row(component).setZero();
  return matrix_of(rows, coarse.unknowns);
}

}  // namespace

template <int dim>
AlgebraicMultigrid<dim>::AlgebraicMultigrid(CoarseProblem<dim> problem, const int most_for_factors,
                                            const MPI_Comm communicator) {
  // As on the mesh.
  constexpr double margin = 1.1;
  // Of the eigenvalues that are smoothed: aggregates of all neighbours are larger than those of a
  // layer, so that more is left to smooth. 10 and 20 take three and two iterations more, 60 one
  // less.
  constexpr double ratio = 40.;
  SymmetricMatrix<n>& matrix = problem.matrix;
  const std::vector<bool> is_moved = complete(matrix);
  const NodePattern& pattern = matrix.pattern();
  if (pattern.unknowns().n_all() <= most_for_factors) {
    direct_ = std::make_unique<DirectSolver<n>>(matrix, Elimination(pattern.unknowns(), {}),
                                                communicator);
    return;
  }
  Vector eigenvector;
  const double largest = margin * largest_eigenvalue(matrix, communicator, eigenvector);
  const auto positions = on_all_nodes(problem.positions, pattern);
  Aggregates aggregates = aggregates_of<n>(pattern, problem.bodies);
  CoarseNodes<dim> coarse = coarse_nodes(aggregates, positions, pattern);
  prolongation_.emplace(smoothed_prolongation<dim>(matrix, positions, coarse, is_moved,
                                                   aggregation_damping / largest));
  coarse_ = std::make_unique<AlgebraicMultigrid>(
      CoarseProblem<dim>{coarse_matrix(matrix, *prolongation_, communicator),
                         std::move(coarse.own_centres), std::move(aggregates.bodies)},
      most_for_factors, communicator);
  coarse_zero_.reinit(coarse.unknowns.own(), communicator);
  matrix_.emplace(std::move(matrix));
  smoother_ =
      std::make_unique<Chebyshev<SymmetricMatrix<n>>>(*matrix_, largest / ratio, margin * largest);
}

template <int dim>
void AlgebraicMultigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  if (direct_) return direct_->vmult(correction, residual);
  v_cycle(*matrix_, *smoother_, *prolongation_, *coarse_, coarse_zero_, correction, residual);
}

template class AlgebraicMultigrid<2>;
template class AlgebraicMultigrid<3>;

}  // namespace geneva::fem
