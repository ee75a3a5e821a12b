#include "fem/multigrid/multigrid.h"

#include <algorithm>
#include <utility>

#include "fem/multigrid/coarse_matrix.h"
#include "fem/multigrid/prolongation.h"
#include "fem/multigrid/v_cycle.h"

namespace geneva::fem {

namespace {

/// The power method comes from below, and Chebyshev's polynomial grows fast beyond its range.
constexpr double margin = 1.1;

/// Coarse levels with so many unknowns are factorised. Their nodes are coupled to so many that
/// aggregates of neighbours would be too coarse: a third coarse level nearly doubles the iterations
/// of 1.9 million unknowns.
int most_for_factors(const dealii::types::global_dof_index of_mesh) {
  constexpr int at_least = 5000;
  constexpr int share = 200;
  return std::max(at_least, static_cast<int>(of_mesh / share));
}

}  // namespace

template <int dim>
Multigrid<dim>::Multigrid(const CondensedMatrix<dim>& matrix,
                          const dealii::DoFHandler<dim>& dof_handler,
                          const dealii::AffineConstraints<double>& constraints)
    : matrix_(matrix),
      largest_eigenvalue_(margin * largest_eigenvalue(matrix, dof_handler.get_communicator())) {
  const MPI_Comm communicator = dof_handler.get_communicator();
  Prolongation<dim> prolonged =
      prolongation(CoupledNodes<dim>(matrix.whole(), dof_handler),
                   {constraints, matrix.elimination(), dof_handler.locally_owned_dofs()},
                   matrix.diagonal(), largest_eigenvalue_, communicator);
  prolongation_.emplace(std::move(prolonged.matrix));
  coarse_ = std::make_unique<AlgebraicMultigrid<dim>>(
      CoarseProblem<dim>{coarse_matrix(matrix.whole(), *prolongation_, communicator),
                         std::move(prolonged.positions), std::move(prolonged.bodies)},
      most_for_factors(dof_handler.n_dofs()), communicator);
  coarse_zero_.reinit(dealii::IndexSet(prolongation_->pattern().unknowns()), communicator);
  renew_smoother();
}

template <int dim>
void Multigrid<dim>::renew_smoother() {
  // Of the eigenvalues that are smoothed; 6 and 20 take an iteration more.
  constexpr double ratio = 10.;
  smoother_ = std::make_unique<Chebyshev<CondensedMatrix<dim>>>(
      matrix_, largest_eigenvalue_ / ratio, margin * largest_eigenvalue_);
}

template <int dim>
void Multigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  v_cycle(matrix_, *smoother_, *prolongation_, *coarse_, coarse_zero_, correction, residual);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace geneva::fem
