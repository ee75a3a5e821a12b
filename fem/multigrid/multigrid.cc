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
                          const dealii::AffineConstraints<double>& constraints,
                          const bool is_factorised)
    : matrix_(matrix),
      communicator_(dof_handler.get_communicator()),
      is_factorised_(is_factorised) {
  if (!is_factorised_) make_levels(dof_handler, constraints);
  renew();
}

template <int dim>
void Multigrid<dim>::make_levels(const dealii::DoFHandler<dim>& dof_handler,
                                 const dealii::AffineConstraints<double>& constraints) {
  largest_eigenvalue_ = margin * largest_eigenvalue(matrix_, communicator_);
  Prolongation<dim> prolonged =
      prolongation(CoupledNodes<dim>(matrix_.whole(), dof_handler),
                   {constraints, matrix_.elimination(), dof_handler.locally_owned_dofs()},
                   matrix_.diagonal(), largest_eigenvalue_, communicator_);
  prolongation_.emplace(std::move(prolonged.matrix));
  coarse_ = std::make_unique<AlgebraicMultigrid<dim>>(
      CoarseProblem<dim>{coarse_matrix(matrix_.whole(), *prolongation_, communicator_),
                         std::move(prolonged.positions), std::move(prolonged.bodies)},
      most_for_factors(dof_handler.n_dofs()), communicator_);
  coarse_zero_.reinit(dealii::IndexSet(prolongation_->pattern().unknowns()), communicator_);
}

template <int dim>
void Multigrid<dim>::renew() {
  if (is_factorised_) {
    direct_.reset();  // before the new factors take memory
    direct_ =
        std::make_unique<DirectSolver<dim>>(matrix_.whole(), matrix_.elimination(), communicator_);
    return;
  }
  // Of the eigenvalues that are smoothed; 6 and 20 take an iteration more.
  constexpr double ratio = 10.;
  smoother_ = std::make_unique<Chebyshev<CondensedMatrix<dim>>>(
      matrix_, largest_eigenvalue_ / ratio, margin * largest_eigenvalue_);
}

template <int dim>
void Multigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  if (direct_) return direct_->vmult(correction, residual);
  v_cycle(matrix_, *smoother_, *prolongation_, *coarse_, coarse_zero_, correction, residual);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace geneva::fem
