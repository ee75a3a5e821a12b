#include "fem/multigrid/coupled_nodes.h"

namespace geneva::fem {

template <int dim>
CoupledNodes<dim>::CoupledNodes(const NodeMatrix<dim>& matrix,
                                const dealii::DoFHandler<dim>& dof_handler)
    : matrix_(matrix), neighbours_(matrix.pattern().own().size()) {
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

template <int dim>
void CoupledNodes<dim>::find_neighbours() {
  for (std::size_t node = 0; node < n_own(); ++node)
    visit_row(node, [&](const std::size_t other, const auto& block) {
      if (other != node && !block.isZero(0.)) neighbours_[node].push_back(other);
    });
}

template <int dim>
std::vector<double> CoupledNodes<dim>::on_all_nodes(const std::vector<double>& of_own_nodes) const {
  Epetra_MultiVector own(matrix_.pattern().unknowns(), 1);
  for (std::size_t node = 0; node < of_own_nodes.size(); ++node)
    own[0][node * dim] = of_own_nodes[node];
  const double* const all = matrix_.pattern().on_all_places(own);
  std::vector<double> result(matrix_.pattern().n_places());
  for (std::size_t node = 0; node < result.size(); ++node) result[node] = all[node * dim];
  return result;
}

template class CoupledNodes<2>;
template class CoupledNodes<3>;

}  // namespace geneva::fem
