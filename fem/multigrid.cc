#include "fem/multigrid.h"

#include <Teuchos_ParameterList.hpp>
#include <array>
#include <vector>

namespace geneva::fem {

namespace {

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

}  // namespace

template <int dim>
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix& matrix,
    const dealii::DoFHandler<dim>& dof_handler,
    const dealii::AffineConstraints<double>& constraints) {
  std::vector<double> modes = rigid_body_modes(dof_handler, constraints);
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
  auto result = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

template std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix&, const dealii::DoFHandler<2>&,
    const dealii::AffineConstraints<double>&);
template std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix&, const dealii::DoFHandler<3>&,
    const dealii::AffineConstraints<double>&);

}  // namespace geneva::fem
