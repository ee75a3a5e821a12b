#include "fem/linear/linear_system.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fem/linear/assembly.h"
#include "fem/linear/multigrid/library_multigrid.h"
#include "fem/linear/multigrid/multigrid.h"

namespace geneva::fem {

namespace {

/// Division by the diagonal.
class Jacobi {
 public:
  explicit Jacobi(std::vector<double> diagonal) : diagonal_(std::move(diagonal)) {}

  void vmult(Vector& correction, const Vector& residual) const {
    const double* const from = residual.begin();
    double* const to = correction.begin();
    for (std::size_t i = 0; i < diagonal_.size(); ++i) to[i] = from[i] / diagonal_[i];
  }

 private:
  std::vector<double> diagonal_;
};

/// Generalised minimum residuals (Saad and Schultz 1986) of a system that is not symmetric,
/// preconditioned from the right, so that the residual is that of the system.
template <typename Matrix, typename Preconditioning>
void minimise_residual(dealii::SolverControl& control, const Matrix& matrix,
                       const Preconditioning& preconditioner, Vector& solution,
                       const Vector& right_hand_side) {
  constexpr unsigned int most_vectors = 60;
  const dealii::SolverGMRES<Vector>::AdditionalData from_the_right(most_vectors, true);
  dealii::SolverGMRES<Vector>(control, from_the_right)
      .solve(matrix, solution, right_hand_side, preconditioner);
}

/// The lines of constraints that others have not.
std::map<int, Shares> lines_beyond(const dealii::AffineConstraints<double>& others,
                                   const dealii::AffineConstraints<double>& constraints) {
  std::map<int, Shares> lines;
  for (const auto& line : constraints.get_lines())
    if (!others.is_constrained(line.index))
      lines[static_cast<int>(line.index)].assign(line.entries.begin(), line.entries.end());
  return lines;
}

}  // namespace

template <int dim>
LinearSystem<dim>::LinearSystem(const dealii::DoFHandler<dim>& dof_handler,
                                const dealii::IndexSet& ghosts,
                                const dealii::AffineConstraints<double>& constraints,
                                const CellSystems& cells,
                                const std::vector<NodalForce>& nodal_forces)
    : owned_(dof_handler.locally_owned_dofs()),
      communicator_(dof_handler.get_communicator()),
      lasting_constraints_(constraints),
      constraints_(constraints),
      whole_load_(owned_, ghosts, communicator_),
      matrix_(assemble<dim>(cells, constraints, owned_, communicator_, whole_load_)),
      load_(owned_, communicator_) {
  for (const NodalForce& force : nodal_forces)
    if (owned_.is_element(force.dof)) whole_load_(force.dof) += force.value;
  whole_load_.compress(dealii::VectorOperation::add);
  load_.copy_locally_owned_data_from(whole_load_);
  zero_with_ghosts_.reinit(owned_, ghosts, communicator_);
}

/// With u = E v + g the load is W^T (f - A g), W = E without friction.
template <int dim>
void LinearSystem<dim>::constrain(const SystemConstraints& constraints) {
  constraints_.copy_from(constraints.displacement);
  matrix_.eliminate(lines_beyond(lasting_constraints_, constraints_));
  frictional_.reset();
  if (constraints.virtual_displacement)
    frictional_.emplace(matrix_,
                        lines_beyond(lasting_constraints_, *constraints.virtual_displacement));
  Vector whole_load(load_);
  whole_load.copy_locally_owned_data_from(whole_load_);
  Vector prescribed(load_);
  prescribed = 0.;
  for (const auto& line : matrix_.elimination().own())
    prescribed.begin()[line.unknown] = constraints_.get_inhomogeneity(
        owned_.nth_index_in_set(static_cast<unsigned int>(line.unknown)));
  matrix_.whole().residual(load_, prescribed, whole_load);
  (frictional_ ? frictional_->virtual_elimination() : matrix_.elimination()).collect(load_);
  if (preconditioner_) preconditioner_->renew();
}

template <int dim>
void LinearSystem<dim>::set_up(const dealii::DoFHandler<dim>& dof_handler, const Method method) {
  preconditioner_.reset();  // before the new one takes memory
  if (method == Method::library_multigrid)
    preconditioner_ = std::make_unique<LibraryMultigrid<dim>>(matrix_, dof_handler);
  else
    preconditioner_ = std::make_unique<Multigrid<dim>>(matrix_, dof_handler, lasting_constraints_,
                                                       method == Method::factors);
}

template <int dim>
unsigned int LinearSystem<dim>::smooth(Vector& displacement) const {
  constexpr unsigned int n_iterations = 15;
  dealii::IterationNumberControl control(n_iterations, 0.);
  constraints_.set_zero(displacement);
  const Jacobi jacobi(matrix_.diagonal());
  if (frictional_)
    minimise_residual(control, *frictional_, jacobi, displacement, load_);
  else
    dealii::SolverCG<Vector>(control).solve(matrix_, displacement, load_, jacobi);
  distribute(displacement);
  return control.last_step();
}

template <int dim>
unsigned int LinearSystem<dim>::solve(Vector& displacement, const double tolerance,
                                      const double reduction) const {
  constexpr unsigned int most_iterations = 1000;
  if (!preconditioner_->is_definite())
    throw dealii::SolverControl::NoConvergence(0, residual_norm(displacement));
  double goal = tolerance * load_.l2_norm();
  if (reduction > 0.) goal = std::max(goal, reduction * residual_norm(displacement));
  constraints_.set_zero(displacement);
  const std::vector<double> diagonal = matrix_.diagonal();
  dealii::SolverControl control(most_iterations, std::max(goal, rounding(displacement, diagonal)));
  // The first guess may know nothing yet of how far a body moves.
  const auto renew_goal = [&](const unsigned int, const double, const Vector& iterate) {
    control.set_tolerance(std::max(goal, rounding(iterate, diagonal)));
    return dealii::SolverControl::success;  // the control decides
  };
  if (frictional_) {
    minimise_residual(control, *frictional_, *preconditioner_, displacement, load_);
  } else {
    dealii::SolverCG<Vector> solver(control);
    solver.connect(renew_goal);
    solver.solve(matrix_, displacement, load_, *preconditioner_);
  }
  distribute(displacement);
  return control.last_step();
}

template <int dim>
double LinearSystem<dim>::rounding(const Vector& displacement,
                                   const std::vector<double>& diagonal) const {
  constexpr double accumulated = 4.;  // roundings of a row add up as the root of its entries
  const double* const values = displacement.begin();
  double square = 0.;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double force = diagonal[i] * values[i];
    square += force * force;
  }
  return accumulated * std::numeric_limits<double>::epsilon() *
         std::sqrt(dealii::Utilities::MPI::sum(square, communicator_));
}

template <int dim>
double LinearSystem<dim>::residual_norm(const Vector& displacement) const {
  Vector free(displacement);
  constraints_.set_zero(free);
  Vector residual(displacement);
  if (frictional_)
    frictional_->residual(residual, free, load_);
  else
    matrix_.residual(residual, free, load_);
  return residual.l2_norm();
}

/// As AffineConstraints::distribute(), which searches for the unknowns that it needs of other ranks
/// and makes a vector for them each time.
template <int dim>
void LinearSystem<dim>::distribute(Vector& displacement) const {
  Vector with_ghosts(zero_with_ghosts_);
  with_ghosts.copy_locally_owned_data_from(displacement);
  with_ghosts.update_ghost_values();
  double* const values = displacement.begin();
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
