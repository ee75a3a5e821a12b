#include "fem/multigrid/coupled_nodes.h"

#include <Epetra_Import.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <map>

namespace geneva::fem {

template <int dim>
CoupledNodes<dim>::CoupledNodes(const dealii::TrilinosWrappers::SparseMatrix& matrix,
                                const dealii::DoFHandler<dim>& dof_handler)
    : matrix_(matrix.trilinos_matrix()),
      neighbours_(static_cast<std::size_t>(matrix_.NumMyRows() / dim)) {
  number_columns();
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  std::vector<std::vector<double>> coordinates(dim, std::vector<double>(n_own()));
  std::vector<double> bodies(n_own());
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const auto dof = cell->vertex_dof_index(vertex, 0);
      if (!owned.is_element(dof)) continue;
      const std::size_t node = owned.index_within_set(dof) / dim;
      for (unsigned int axis = 0; axis < dim; ++axis)
        coordinates[axis][node] = cell->vertex(vertex)[axis];
      bodies[node] = cell->material_id();
    }
  }
  for (unsigned int axis = 0; axis < dim; ++axis) {
    const std::vector<double> all = on_all_nodes(coordinates[axis]);
    positions_.resize(all.size());
    for (std::size_t node = 0; node < all.size(); ++node) positions_[node][axis] = all[node];
  }
  for (const double body : on_all_nodes(bodies)) bodies_.push_back(static_cast<unsigned int>(body));
  find_neighbours();
}

/// A node's unknowns follow each other; the columns of other ranks may lack some of them.
template <int dim>
void CoupledNodes<dim>::number_columns() {
  std::map<int, std::size_t> others;
  for (int column = 0; column < matrix_.NumMyCols(); ++column) {
    const int unknown = matrix_.GCID(column);
    const int row = matrix_.LRID(unknown);
    const std::size_t node =
        row >= 0 ? static_cast<std::size_t>(row / dim)
                 : others.emplace(unknown / dim, n_own() + others.size()).first->second;
    node_of_column_.push_back(node);
    component_of_column_.push_back(static_cast<unsigned int>(unknown % dim));
    if (row < 0) others_.push_back({unknown, node, component_of_column_.back()});
  }
}

template <int dim>
void CoupledNodes<dim>::find_neighbours() {
  for (std::size_t node = 0; node < n_own(); ++node) {
    std::vector<std::size_t>& list = neighbours_[node];
    for (unsigned int component = 0; component < dim; ++component)
      visit_row(node, component, [&](const Entry& entry) {
        if (entry.node != node && entry.value != 0.) list.push_back(entry.node);
      });
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    list.shrink_to_fit();
  }
}

template <int dim>
std::vector<double> CoupledNodes<dim>::on_all_nodes(const std::vector<double>& of_own_nodes) const {
  Epetra_Vector rows(matrix_.RowMap());
  for (int row = 0; row < matrix_.NumMyRows(); ++row)
    rows[row] = of_own_nodes[static_cast<std::size_t>(row / dim)];
  std::vector<double> result = of_own_nodes;
  if (matrix_.Importer() == nullptr) return result;  // one rank
  Epetra_Vector columns(matrix_.ColMap());
  columns.Import(rows, *matrix_.Importer(), Insert);
  for (int column = 0; column < matrix_.NumMyCols(); ++column) {
    const std::size_t node = node_of_column_[static_cast<std::size_t>(column)];
    result.resize(std::max(result.size(), node + 1));
    result[node] = columns[column];
  }
  return result;
}

template class CoupledNodes<2>;
template class CoupledNodes<3>;

}  // namespace geneva::fem
