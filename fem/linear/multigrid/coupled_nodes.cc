#include "fem/linear/multigrid/coupled_nodes.h"

#include "fem/linear/multigrid/coarse_nodes.h"

namespace geneva::fem {

template <int dim>
CoupledNodes<dim>::CoupledNodes(const SymmetricMatrix<dim>& matrix,
                                const dealii::DoFHandler<dim>& dof_handler)
    : matrix_(matrix), neighbours_(matrix.pattern().own().size()) {
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  std::vector<dealii::Point<dim>> positions(n_own());
  std::vector<double> bodies(n_own());
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const auto dof = cell->vertex_dof_index(vertex, 0);
      if (!owned.is_element(dof)) continue;
      const std::size_t node = owned.index_within_set(dof) / dim;
      positions[node] = cell->vertex(vertex);
      bodies[node] = cell->material_id();
    }
  }
  positions_ = fem::on_all_nodes(positions, matrix.pattern());
  for (const double body : on_all_nodes(bodies)) bodies_.push_back(static_cast<unsigned int>(body));
  find_neighbours();
}

template <int dim>
void CoupledNodes<dim>::find_neighbours() {
  matrix_.visit_blocks([&](const std::size_t node, const std::size_t other, const auto& block) {
    if (other != node && !block.isZero(0.)) neighbours_[node].push_back(other);
  });
}

template class CoupledNodes<2>;
template class CoupledNodes<3>;

}  // namespace geneva::fem
