#include "fem/linear_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

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

  if (similar != nullptr) {
    multigrid_matrix_ = similar->multigrid_matrix_;
    multigrid_ = similar->multigrid_;
    return;
  }
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
  options.elliptic = true;
  options.smoother_sweeps = 2;
  options.aggregation_threshold = 0.02;
  dealii::DoFTools::extract_constant_modes(dof_handler, dealii::ComponentMask(),
                                           options.constant_modes);
  multigrid_matrix_ = matrix_;
  multigrid_ = std::make_shared<dealii::TrilinosWrappers::PreconditionAMG>();
  multigrid_->initialize(*multigrid_matrix_, options);
}

template LinearSystem::LinearSystem(const dealii::DoFHandler<2>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&,
                                    const LinearSystem*);
template LinearSystem::LinearSystem(const dealii::DoFHandler<3>&, const dealii::IndexSet&,
                                    const dealii::AffineConstraints<double>&,
                                    const std::vector<CellSystem>&, const std::vector<NodalForce>&,
                                    const LinearSystem*);

unsigned int LinearSystem::solve(Vector& displacement, const double tolerance) const {
  Vector load(displacement);
  load = load_;
  dealii::SolverControl control(1000, tolerance * load.l2_norm());
  dealii::SolverCG<Vector> solver(control);
  constraints_.set_zero(displacement);
  solver.solve(*matrix_, displacement, load, *multigrid_);
  constraints_.distribute(displacement);
  return control.last_step();
}

}  // namespace geneva::fem
