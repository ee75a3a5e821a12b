#include "fem/linear/multigrid/multigrid.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/linear/multigrid/coarse_matrix.h"
#include "fem/linear/multigrid/prolongation.h"
#include "fem/linear/multigrid/v_cycle.h"

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
  if (is_factorised_)
    factorise();
  else
    make_levels(dof_handler, constraints);
}

template <int dim>
void Multigrid<dim>::make_levels(const dealii::DoFHandler<dim>& dof_handler,
                                 const dealii::AffineConstraints<double>& constraints) {
  diagonal_ = matrix_.diagonal();
  largest_eigenvalue_ = margin * largest_eigenvalue(matrix_, communicator_, eigenvector_);
  Prolongation<dim> prolonged =
      prolongation(CoupledNodes<dim>(matrix_.whole(), dof_handler),
                   {constraints, matrix_.elimination(), dof_handler.locally_owned_dofs()},
                   matrix_.diagonal(), largest_eigenvalue_, communicator_);
  prolongation_.emplace(std::move(prolonged.matrix));
  coarse_ = std::make_unique<AlgebraicMultigrid<dim>>(
      CoarseProblem<dim>{coarse_matrix(matrix_.whole(), *prolongation_, communicator_),
                         std::move(prolonged.positions), std::move(prolonged.bodies)},
      most_for_factors(dof_handler.n_dofs()), communicator_);
  coarse_zero_.reinit(prolongation_->pattern().unknowns().own(), communicator_);
  make_smoother();
}

/// A new eigenvector can only stand where the matrix has changed: the search starts there and at
/// the one before.
template <int dim>
void Multigrid<dim>::renew_eigenvalue() {
  constexpr int n_steps = 5;
  const std::vector<double> before = std::exchange(diagonal_, matrix_.diagonal());
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < diagonal_.size(); ++i)
    if (diagonal_[i] != before[i]) changed.push_back(i);
  const std::size_t n_changed = dealii::Utilities::MPI::sum(changed.size(), communicator_);
  if (n_changed == 0) return;
  const double size = eigenvector_.l2_norm() / std::sqrt(static_cast<double>(n_changed));
  double* const values = eigenvector_.begin();
  for (const std::size_t i : changed) values[i] += i % 2 == 0 ? size : -size;
  largest_eigenvalue_ = margin * largest_eigenvalue(matrix_, eigenvector_, n_steps);
}

template <int dim>
void Multigrid<dim>::renew() {
  if (is_factorised_) {
    factorise();
    return;
  }
  renew_eigenvalue();
  make_smoother();
}

template <int dim>
void Multigrid<dim>::factorise() {
  direct_.reset();  // before the new factors take memory
  direct_ =
      std::make_unique<DirectSolver<dim>>(matrix_.whole(), matrix_.elimination(), communicator_);
}

template <int dim>
double Multigrid<dim>::maximum_smoothed() const {
  return margin * largest_eigenvalue_;
}

template <int dim>
void Multigrid<dim>::make_smoother() {
  // Of the eigenvalues that are smoothed; 6 and 20 take an iteration more.
  constexpr double ratio = 10.;
  smoother_ = std::make_unique<Chebyshev<CondensedMatrix<dim>>>(
      matrix_, largest_eigenvalue_ / ratio, maximum_smoothed());
}

template <int dim>
void Multigrid<dim>::vmult(Vector& correction, const Vector& residual) const {
  if (direct_) return direct_->vmult(correction, residual);
  v_cycle(matrix_, *smoother_, *prolongation_, *coarse_, coarse_zero_, correction, residual);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace geneva::fem
