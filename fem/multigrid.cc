#include "fem/multigrid.h"

#include <ml_include.h>

#include <ml_agg_user.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "fem/aggregation.h"

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

/// Bodies of this rank's nodes: each node belongs to one body, also where two touch.
template <int dim>
std::vector<unsigned int> bodies_of_nodes(const dealii::DoFHandler<dim>& dof_handler) {
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  std::vector<unsigned int> result(owned.n_elements() / dim);
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const auto dof = cell->vertex_dof_index(vertex, 0);
      if (owned.is_element(dof)) result[owned.index_within_set(dof) / dim] = cell->material_id();
    }
  }
  return result;
}

/// Bodies of this rank's nodes on the level that ML coarsens next. ML hands its callbacks nothing
/// of the caller's, so that this cannot be an argument.
thread_local std::vector<unsigned int> bodies_of_level;
/// Two nodes have as many unknowns as there are rigid-body modes, one coarse node has, too.
thread_local unsigned int least_nodes_of_level;

/// Neighbours of this rank's nodes on this rank; a node with unknowns of its own that only other
/// ranks' nodes are coupled to is its own neighbour.
std::vector<std::vector<int>> neighbours_of_nodes(ML_Operator* matrix, int* n_entries) {
  const int n_nodes = matrix->outvec_leng;
  std::vector<std::vector<int>> result(static_cast<std::size_t>(n_nodes));
  std::vector<int> columns(256);
  std::vector<double> values(columns.size());
  for (int node = 0; node < n_nodes; ++node) {
    int count = 0;
    while (ML_Operator_Getrow(matrix, 1, &node, static_cast<int>(columns.size()), columns.data(),
                              values.data(), &count) == 0) {
      columns.resize(2 * columns.size());
      values.resize(columns.size());
    }
    *n_entries += count;
    auto& neighbours = result[static_cast<std::size_t>(node)];
    std::copy_if(columns.begin(), columns.begin() + count, std::back_inserter(neighbours),
                 [&](const int other) { return other != node && other < n_nodes; });
    if (neighbours.empty() && count > 1) neighbours.push_back(node);
  }
  return result;
}

}  // namespace

// What ML calls, with the types that it asks for.
extern "C" {

static char* label_of_aggregation() {
  static std::array<char, 16> label{"within bodies"};
  return label.data();
}

static int aggregate_within_bodies(ML_Operator* matrix, char* is_given, double, double*, double*,
                                   double*, int* of_nodes, int* n_entries) {
  *n_entries = 0;
  std::fill_n(is_given, matrix->outvec_leng, 'F');  // the modes have zeros for given values already
  Aggregates aggregates =
      aggregate(neighbours_of_nodes(matrix, n_entries), bodies_of_level, least_nodes_of_level);
  std::copy(aggregates.of_nodes.begin(), aggregates.of_nodes.end(), of_nodes);
  bodies_of_level = std::move(aggregates.bodies);
  least_nodes_of_level = 1;
  return static_cast<int>(bodies_of_level.size());
}
}

template <int dim>
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> multigrid(
    const dealii::TrilinosWrappers::SparseMatrix& matrix,
    const dealii::DoFHandler<dim>& dof_handler,
    const dealii::AffineConstraints<double>& constraints) {
  std::vector<double> modes = rigid_body_modes(dof_handler, constraints);
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
  options.elliptic = true;
  options.smoother_sweeps = 2;
  options.aggregation_threshold = 0.;
  Teuchos::ParameterList list;
  std::unique_ptr<Epetra_MultiVector> unused;
  options.set_parameters(list, unused, matrix);
  list.set("PDE equations", dim);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(n_rigid_body_modes<dim>));
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  bodies_of_level = bodies_of_nodes(dof_handler);
  least_nodes_of_level = 2;
  ML_SetUserLabel(label_of_aggregation);
  ML_SetUserPartitions(aggregate_within_bodies);
  list.set("aggregation: type", "user");
  list.set("increasing or decreasing", "decreasing");  // so ML takes a node for all its unknowns
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
