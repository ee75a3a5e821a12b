#include "fem/linear_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>

#include "fem/assembly.h"
#include "fem/condensation.h"

namespace geneva::fem {

namespace {

using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// What the cells at some unknowns contribute to the system with one set of constraints less what
/// they contribute with another.
std::vector<CellSystem> differences(const std::vector<CellSystem>& cells,
                                    const std::set<dealii::types::global_dof_index>& changed,
                                    const dealii::AffineConstraints<double>& before,
                                    const dealii::AffineConstraints<double>& after) {
  std::vector<CellSystem> result;
  for (const CellSystem& cell : cells) {
    if (std::none_of(cell.dofs.begin(), cell.dofs.end(),
                     [&](const auto dof) { return changed.count(dof) > 0; }))
      continue;
    result.push_back(condensed(cell, after));
    result.push_back(condensed(cell, before));
    result.back().stiffness *= -1.;
    result.back().load *= -1.;
  }
  return result;
}

/// A matrix that is the sum of the one of the first constraints and a correction.
class CorrectedMatrix {
 public:
  CorrectedMatrix(const Matrix& matrix, const Matrix* correction)
      : matrix_(matrix), correction_(correction) {}

  void vmult(Vector& result, const Vector& vector) const {
    matrix_.vmult(result, vector);
    if (correction_ != nullptr) correction_->vmult_add(result, vector);
  }

 private:
  const Matrix& matrix_;
  const Matrix* correction_;
};

/// A preconditioner whose corrections vanish where constraints give the values: made for a system
/// with other constraints, it would correct unknowns that are none now.
class OnFreeUnknowns {
 public:
  OnFreeUnknowns(const dealii::TrilinosWrappers::PreconditionBase& preconditioner,
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
  const dealii::TrilinosWrappers::PreconditionBase& preconditioner_;
  std::vector<int> given_;  ///< among this rank's unknowns
};

}  // namespace

template <int dim>
LinearSystem::LinearSystem(const dealii::DoFHandler<dim>& dof_handler,
                           const dealii::IndexSet& ghosts,
                           const dealii::AffineConstraints<double>& constraints,
                           const std::vector<CellSystem>& cells,
                           const std::vector<NodalForce>& nodal_forces)
    : owned_(dof_handler.locally_owned_dofs()),
      ghosts_(ghosts),
      communicator_(dof_handler.get_communicator()),
      first_constraints_(constraints),
      constraints_(constraints) {
  load_.reinit(owned_, ghosts_, communicator_, true);
  zero_with_ghosts_.reinit(owned_, ghosts_, communicator_);
  assemble<dim>(cells, constraints, owned_, communicator_, matrix_, load_);
  for (const NodalForce& force : nodal_forces)
    if (owned_.is_element(force.dof)) load_(force.dof) += force.value;
  load_.compress(dealii::VectorOperation::add);
  first_load_ = load_;
}

template <int dim>
void LinearSystem::set_up_multigrid(const dealii::DoFHandler<dim>& dof_handler) {
  multigrid_ = std::make_unique<Multigrid>(matrix_, dof_handler, first_constraints_);
}

void LinearSystem::change(const dealii::AffineConstraints<double>& constraints,
                          const std::vector<CellSystem>& cells) {
  constraints_.copy_from(constraints);
  const auto changed = changed_unknowns(first_constraints_, constraints_);
  const auto changes = differences(cells, changed, first_constraints_, constraints_);
  dealii::TrilinosWrappers::SparsityPattern pattern(owned_, owned_, ghosts_, communicator_, 1);
  for (const CellSystem& cell : changes)
    for (const auto row : cell.dofs) pattern.add_entries(row, cell.dofs.begin(), cell.dofs.end());
  pattern.compress();
  correction_ = std::make_unique<Matrix>();
  correction_->reinit(pattern);
  load_ = first_load_;
  for (const CellSystem& cell : changes) {
    correction_->add(cell.dofs, cell.stiffness);
    load_.add(cell.dofs, cell.load);
  }
  correct_diagonal(changed);
  correction_->compress(dealii::VectorOperation::add);
  load_.compress(dealii::VectorOperation::add);
}

/// A constrained unknown stands alone in the matrix, with a diagonal of its own: it goes where the
/// unknown has become free, and comes where it was.
void LinearSystem::correct_diagonal(const std::set<dealii::types::global_dof_index>& changed) {
  for (const auto dof : changed) {
    if (!owned_.is_element(dof)) continue;
    const bool was_free = !first_constraints_.is_constrained(dof);
    const bool is_free = !constraints_.is_constrained(dof);
    if (was_free != is_free)
      correction_->add(dof, dof, (was_free ? 1. : -1.) * matrix_.el(dof, dof));
  }
}

unsigned int LinearSystem::smooth(Vector& displacement) const {
  constexpr unsigned int n_iterations = 15;
  dealii::TrilinosWrappers::PreconditionJacobi jacobi;
  jacobi.initialize(matrix_);
  dealii::IterationNumberControl control(n_iterations, 0.);
  return iterate(displacement, jacobi, control);
}

unsigned int LinearSystem::solve(Vector& displacement, const double tolerance,
                                 const double reduction) const {
  constexpr unsigned int most_iterations = 1000;
  double goal = tolerance * load_.l2_norm();
  if (reduction > 0.) goal = std::max(goal, reduction * residual_norm(displacement));
  dealii::SolverControl control(most_iterations, goal);
  return iterate(displacement, *multigrid_, control);
}

double LinearSystem::residual_norm(const Vector& displacement) const {
  Vector free(displacement);
  constraints_.set_zero(free);
  Vector load(displacement);
  load = load_;
  Vector residual(displacement);
  CorrectedMatrix(matrix_, correction_.get()).vmult(residual, free);
  residual -= load;
  return residual.l2_norm();
}

unsigned int LinearSystem::iterate(Vector& displacement,
                                   const dealii::TrilinosWrappers::PreconditionBase& preconditioner,
                                   dealii::SolverControl& control) const {
  Vector load(displacement);
  load = load_;
  constraints_.set_zero(displacement);
  dealii::SolverCG<Vector> solver(control);
  solver.solve(CorrectedMatrix(matrix_, correction_.get()), displacement, load,
               OnFreeUnknowns(preconditioner, constraints_, owned_));
  distribute(displacement);
  return control.last_step();
}

/// As AffineConstraints::distribute(), which searches for the unknowns that it needs of other ranks
/// and makes a vector for them each time.
void LinearSystem::distribute(Vector& displacement) const {
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

template LinearSystem::LinearSystem(const dealii::DoFHandler<2>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&);
template LinearSystem::LinearSystem(const dealii::DoFHandler<3>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&);

template void LinearSystem::set_up_multigrid(const dealii::DoFHandler<2>&);
template void LinearSystem::set_up_multigrid(const dealii::DoFHandler<3>&);

}  // namespace geneva::fem
