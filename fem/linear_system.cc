#include "fem/linear_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>

namespace geneva::fem {

namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

void assemble(const dealii::AffineConstraints<double>& constraints,
              const std::vector<CellSystem>& cells, const std::vector<NodalForce>& nodal_forces,
              dealii::TrilinosWrappers::SparseMatrix& matrix, Vector& load) {
  for (const CellSystem& cell : cells)
    constraints.distribute_local_to_global(cell.stiffness, cell.load, cell.dofs, matrix, load);
  for (const NodalForce& force : nodal_forces)
    if (load.locally_owned_elements().is_element(force.dof)) load(force.dof) += force.value;
  matrix.compress(dealii::VectorOperation::add);
  load.compress(dealii::VectorOperation::add);
}

template <int dim>
constexpr unsigned int n_rigid_body_modes = dim == 2 ? 3 : 6;

/// Displacement of a vertex in a rigid-body mode: translations first, then rotations about the
/// origin.
dealii::Tensor<1, 2> rigid_body_mode(const unsigned int mode, const dealii::Point<2>& at) {
  return std::array<dealii::Tensor<1, 2>, 3>{dealii::Tensor<1, 2>({1., 0.}),
                                             dealii::Tensor<1, 2>({0., 1.}),
                                             dealii::Tensor<1, 2>({-at[1], at[0]})}[mode];
}
dealii::Tensor<1, 3> rigid_body_mode(const unsigned int mode, const dealii::Point<3>& at) {
  dealii::Tensor<1, 3> axis;
  axis[mode % 3] = 1.;
  return mode < 3 ? axis : dealii::cross_product_3d(axis, dealii::Tensor<1, 3>(at));
}

/// The rigid-body modes at this rank's unknowns, one after the other. They are zero where a
/// constraint gives the value: those rows of the matrix stand alone, and a coarse function with a
/// value there would be stiff for nothing.
template <int dim>
std::vector<double> rigid_body_modes(const dealii::DoFHandler<dim>& dof_handler,
                                     const dealii::AffineConstraints<double>& constraints) {
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  std::vector<double> modes(n_rigid_body_modes<dim> * owned.n_elements(), 0.);
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int vertex : cell->vertex_indices())
      for (unsigned int component = 0; component < dim; ++component) {
        const auto dof = cell->vertex_dof_index(vertex, component);
        if (!owned.is_element(dof) || constraints.is_constrained(dof)) continue;
        for (unsigned int mode = 0; mode < n_rigid_body_modes<dim>; ++mode)
          modes[mode * owned.n_elements() + owned.index_within_set(dof)] =
              rigid_body_mode(mode, cell->vertex(vertex))[component];
      }
  }
  return modes;
}

/// Smoothed aggregation that reproduces the rigid-body modes (Vanek, Mandel and Brezina 1996).
template <int dim>
std::shared_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix& matrix, std::vector<double> modes) {
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
  options.elliptic = true;
  options.smoother_sweeps = 2;
  options.aggregation_threshold = 0.02;
  Teuchos::ParameterList list;
  std::unique_ptr<Epetra_MultiVector> unused;
  options.set_parameters(list, unused, matrix);
  list.set("PDE equations", dim);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(n_rigid_body_modes<dim>));
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  auto result = std::make_shared<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

/// A preconditioner whose corrections vanish where constraints give the values: taken over from a
/// system with other constraints, it would correct unknowns that are none now.
class OnFreeUnknowns {
 public:
  OnFreeUnknowns(const dealii::TrilinosWrappers::PreconditionAMG& multigrid,
                 const dealii::AffineConstraints<double>& constraints)
      : multigrid_(multigrid), constraints_(constraints) {}

  void vmult(Vector& correction, const Vector& residual) const {
    multigrid_.vmult(correction, residual);
    constraints_.set_zero(correction);
  }

 private:
  const dealii::TrilinosWrappers::PreconditionAMG& multigrid_;
  const dealii::AffineConstraints<double>& constraints_;
};

}  // namespace

template <int dim>
LinearSystem::LinearSystem(const dealii::DoFHandler<dim>& dof_handler,
                           const dealii::IndexSet& ghosts,
                           const dealii::AffineConstraints<double>& constraints,
                           const std::vector<CellSystem>& cells,
                           const std::vector<NodalForce>& nodal_forces, const LinearSystem* similar)
    : constraints_(constraints),
      matrix_(std::make_shared<dealii::TrilinosWrappers::SparseMatrix>()) {
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  const MPI_Comm communicator = dof_handler.get_communicator();
  dealii::TrilinosWrappers::SparsityPattern pattern(owned, owned, ghosts, communicator, 20);
  dealii::DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false,
                                          dealii::Utilities::MPI::this_mpi_process(communicator));
  pattern.compress();
  matrix_->reinit(pattern);
  load_.reinit(owned, ghosts, communicator, true);
  assemble(constraints, cells, nodal_forces, *matrix_, load_);

  if (similar == nullptr) {
    set_up_multigrid(dof_handler);
    return;
  }
  multigrid_matrix_ = similar->multigrid_matrix_;
  multigrid_ = similar->multigrid_;
}

template <int dim>
void LinearSystem::set_up_multigrid(const dealii::DoFHandler<dim>& dof_handler) {
  if (multigrid_matrix_ == matrix_) return;
  multigrid_matrix_ = matrix_;
  multigrid_ = multigrid<dim>(*multigrid_matrix_, rigid_body_modes(dof_handler, constraints_));
}

template LinearSystem::LinearSystem(const dealii::DoFHandler<2>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&,
                                    const LinearSystem*);
template LinearSystem::LinearSystem(const dealii::DoFHandler<3>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&,
                                    const LinearSystem*);

template void LinearSystem::set_up_multigrid(const dealii::DoFHandler<2>&);
template void LinearSystem::set_up_multigrid(const dealii::DoFHandler<3>&);

unsigned int LinearSystem::solve(Vector& displacement, const double tolerance,
                                 const double reduction) const {
  constexpr unsigned int most_iterations = 1000;
  Vector load(displacement);
  load = load_;
  constraints_.set_zero(displacement);
  double goal = tolerance * load.l2_norm();
  if (reduction > 0.) {
    Vector residual(displacement);
    goal = std::max(goal, reduction * matrix_->residual(residual, displacement, load));
  }
  dealii::SolverControl control(most_iterations, goal);
  dealii::SolverCG<Vector> solver(control);
  solver.solve(*matrix_, displacement, load, OnFreeUnknowns(*multigrid_, constraints_));
  constraints_.distribute(displacement);
  return control.last_step();
}

}  // namespace geneva::fem
