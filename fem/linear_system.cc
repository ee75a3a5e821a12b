#include "fem/linear_system.h"

#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <set>

#include "fem/assembly.h"
#include "fem/condensation.h"
#include "fem/marked_unknowns.h"

namespace geneva::fem {

namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// What the cells at some unknowns contribute to the system with one set of constraints less what
/// they contribute with another.
std::vector<CellSystem> differences(const std::vector<CellSystem>& cells,
                                    const std::set<dealii::types::global_dof_index>& changed,
                                    const dealii::AffineConstraints<double>& before,
                                    const dealii::AffineConstraints<double>& after) {
  const MarkedUnknowns marked(changed);
  std::vector<CellSystem> result;
  for (const CellSystem& cell : cells) {
    if (std::none_of(cell.dofs.begin(), cell.dofs.end(),
                     [&](const auto dof) { return marked.have(dof); }))
      continue;
    result.push_back(condensed(cell, after));
    result.push_back(condensed(cell, before));
    result.back().stiffness *= -1.;
    result.back().load *= -1.;
  }
  return result;
}

/// Division by the diagonal.
class Jacobi {
 public:
  explicit Jacobi(std::vector<double> diagonal) : diagonal_(std::move(diagonal)) {}

  void vmult(Vector& correction, const Vector& residual) const {
    const double* const from = residual.trilinos_vector()[0];
    double* const to = correction.trilinos_vector()[0];
    for (std::size_t i = 0; i < diagonal_.size(); ++i) to[i] = from[i] / diagonal_[i];
  }

 private:
  std::vector<double> diagonal_;
};

/// A preconditioner whose corrections vanish where constraints give the values: made for a system
/// with other constraints, it would correct unknowns that are none now.
template <typename Preconditioner>
class OnFreeUnknowns {
 public:
  OnFreeUnknowns(const Preconditioner& preconditioner,
                 const dealii::AffineConstraints<double>& constraints,
                 const dealii::IndexSet& owned)
      : preconditioner_(preconditioner) {
    for (const auto& line : constraints.get_lines())
      if (owned.is_element(line.index))
        given_.push_back(static_cast<int>(owned.index_within_set(line.index)));
  }

  void vmult(Vector& correction, const Vector& residual) const {
    preconditioner_.vmult(correction, residual);
    double* const values = correction.trilinos_vector()[0];
    for (const int unknown : given_) values[unknown] = 0.;
  }

 private:
  const Preconditioner& preconditioner_;
  std::vector<int> given_;  ///< among this rank's unknowns
};

/// Loads that this rank may write to.
Vector writable(const dealii::IndexSet& owned, const dealii::IndexSet& ghosts,
                const MPI_Comm communicator) {
  Vector result;
  result.reinit(owned, ghosts, communicator, true);
  return result;
}

}  // namespace

template <int dim>
LinearSystem<dim>::LinearSystem(const dealii::DoFHandler<dim>& dof_handler,
                                const dealii::IndexSet& ghosts,
                                const dealii::AffineConstraints<double>& constraints,
                                const std::vector<CellSystem>& cells,
                                const std::vector<NodalForce>& nodal_forces)
    : owned_(dof_handler.locally_owned_dofs()),
      communicator_(dof_handler.get_communicator()),
      first_constraints_(constraints),
      constraints_(constraints),
      load_(writable(owned_, ghosts, communicator_)),
      matrix_(assemble<dim>(cells, constraints, owned_, communicator_, load_)) {
  for (const NodalForce& force : nodal_forces)
    if (owned_.is_element(force.dof)) load_(force.dof) += force.value;
  load_.compress(dealii::VectorOperation::add);
  first_load_ = load_;
  zero_with_ghosts_.reinit(owned_, ghosts, communicator_);
}

template <int dim>
void LinearSystem<dim>::set_up_multigrid(const dealii::DoFHandler<dim>& dof_handler) {
  multigrid_ = std::make_unique<Multigrid<dim>>(matrix_, dof_handler, first_constraints_);
}

template <int dim>
void LinearSystem<dim>::change(const dealii::AffineConstraints<double>& constraints,
                               const std::vector<CellSystem>& cells) {
  constraints_.copy_from(constraints);
  load_ = first_load_;
  dealii::AffineConstraints<double> none;
  none.close();
  matrix_.correct(assemble<dim>(changes_from_first(cells), none, owned_, communicator_, load_));
  load_.compress(dealii::VectorOperation::add);
  if (multigrid_) multigrid_->renew_smoother();
}

/// A constrained unknown stands alone in the matrix, with a diagonal of its own: it goes where the
/// unknown has become free, and comes where it was.
template <int dim>
std::vector<CellSystem> LinearSystem<dim>::changes_from_first(
    const std::vector<CellSystem>& cells) const {
  const auto changed = changed_unknowns(first_constraints_, constraints_);
  auto changes = differences(cells, changed, first_constraints_, constraints_);
  const std::vector<double> diagonal = matrix_.uncorrected().diagonal();
  for (const auto dof : changed) {
    if (!owned_.is_element(dof)) continue;
    const bool was_free = !first_constraints_.is_constrained(dof);
    if (was_free != constraints_.is_constrained(dof)) continue;
    changes.push_back({dealii::FullMatrix<double>(1), dealii::Vector<double>(1), {dof}});
    changes.back().stiffness(0, 0) = (was_free ? 1. : -1.) * diagonal[owned_.index_within_set(dof)];
  }
  return changes;
}

template <int dim>
unsigned int LinearSystem<dim>::smooth(Vector& displacement) const {
  constexpr unsigned int n_iterations = 15;
  dealii::IterationNumberControl control(n_iterations, 0.);
  return iterate(displacement, Jacobi(matrix_.diagonal()), control);
}

template <int dim>
unsigned int LinearSystem<dim>::solve(Vector& displacement, const double tolerance,
                                      const double reduction) const {
  constexpr unsigned int most_iterations = 1000;
  double goal = tolerance * load_.l2_norm();
  if (reduction > 0.) goal = std::max(goal, reduction * residual_norm(displacement));
  dealii::SolverControl control(most_iterations, goal);
  return iterate(displacement, *multigrid_, control);
}

template <int dim>
double LinearSystem<dim>::residual_norm(const Vector& displacement) const {
  Vector free(displacement);
  constraints_.set_zero(free);
  Vector load(displacement);
  load = load_;
  Vector residual(displacement);
  matrix_.residual(residual, free, load);
  return residual.l2_norm();
}

template <int dim>
template <typename Preconditioner>
unsigned int LinearSystem<dim>::iterate(Vector& displacement, const Preconditioner& preconditioner,
                                        dealii::SolverControl& control) const {
  Vector load(displacement);
  load = load_;
  constraints_.set_zero(displacement);
  dealii::SolverCG<Vector> solver(control);
  solver.solve(matrix_, displacement, load,
               OnFreeUnknowns<Preconditioner>(preconditioner, constraints_, owned_));
  distribute(displacement);
  return control.last_step();
}

/// As AffineConstraints::distribute(), which searches for the unknowns that it needs of other ranks
/// and makes a vector for them each time.
template <int dim>
void LinearSystem<dim>::distribute(Vector& displacement) const {
  Vector with_ghosts(zero_with_ghosts_);
  with_ghosts = displacement;
  double* const values = displacement.trilinos_vector()[0];
  for (const auto& line : constraints_.get_lines()) {
    if (!owned_.is_element(line.index)) continue;
    double value = line.inhomogeneity;
    for (const auto& [carrier, share] : line.entries) value += share * with_ghosts(carrier);
    values[owned_.index_within_set(line.index)] = value;
  }
}

template class LinearSystem<2>;
template class LinearSystem<3>;

}  // namespace geneva::fem
