#include "fem/discretisation/numbering.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/index_set.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace geneva::fem {

namespace {

using Dof = dealii::types::global_dof_index;

/// Nodes of this rank, which share its cells.
template <int dim>
class NodeGraph {
 public:
  explicit NodeGraph(const dealii::DoFHandler<dim>& dof_handler)
      : first_cells_(dof_handler.n_locally_owned_dofs() / dim + 1, 0) {
    const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
    for (const auto& cell : dof_handler.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      Nodes& nodes = cells_.emplace_back();
      for (const unsigned int vertex : cell->vertex_indices()) {
        const Dof dof = cell->vertex_dof_index(vertex, 0);
        nodes[vertex] = owned.is_element(dof) ? owned.index_within_set(dof) / dim : of_other_rank;
      }
    }
    sort_cells_by_nodes();
  }

  [[nodiscard]] std::size_t n_nodes() const { return first_cells_.size() - 1; }

  /// The nodes that hang together with one, its neighbours first, then theirs.
  /// @param is_met nodes met before; in and out
  [[nodiscard]] std::vector<std::size_t> from(const std::size_t start,
                                              std::vector<bool>& is_met) const {
    std::vector<std::size_t> met{start};
    is_met[start] = true;
    for (std::size_t next = 0; next < met.size(); ++next)
      for (std::size_t i = first_cells_[met[next]]; i < first_cells_[met[next] + 1]; ++i)
        for (const std::size_t node : cells_[cells_of_nodes_[i]]) {
          if (node == of_other_rank || is_met[node]) continue;
          is_met[node] = true;
          met.push_back(node);
        }
    return met;
  }

 private:
  using Nodes = std::array<std::size_t, dealii::GeometryInfo<dim>::vertices_per_cell>;
  static constexpr std::size_t of_other_rank = std::numeric_limits<std::size_t>::max();

  void sort_cells_by_nodes() {
    for (const Nodes& nodes : cells_)
      for (const std::size_t node : nodes)
        if (node != of_other_rank) ++first_cells_[node];
    std::size_t end = 0;
    for (std::size_t& first : first_cells_) first = end += first;
    cells_of_nodes_.resize(end);
    for (std::size_t cell = cells_.size(); cell-- > 0;)
      for (const std::size_t node : cells_[cell])
        if (node != of_other_rank) cells_of_nodes_[--first_cells_[node]] = cell;
  }

  std::vector<Nodes> cells_;
  std::vector<std::size_t> first_cells_;  ///< of each node, and the end
  std::vector<std::size_t> cells_of_nodes_;
};

/// Nodes in the order of their new numbers.
template <int dim>
std::vector<std::size_t> reverse_cuthill_mckee(const NodeGraph<dim>& graph) {
  std::vector<std::size_t> order;
  std::vector<bool> is_searched(graph.n_nodes(), false);
  std::vector<bool> is_met(graph.n_nodes(), false);
  for (std::size_t node = 0; node < graph.n_nodes(); ++node) {
    if (is_met[node]) continue;
    const std::size_t end = graph.from(node, is_searched).back();
    const std::vector<std::size_t> part = graph.from(end, is_met);
    order.insert(order.end(), part.begin(), part.end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace

template <int dim>
void number_by_neighbours(dealii::DoFHandler<dim>& dof_handler) {
  const std::vector<std::size_t> order = reverse_cuthill_mckee(NodeGraph<dim>(dof_handler));
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  std::vector<Dof> numbers(owned.n_elements());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t component = 0; component < dim; ++component)
      numbers[dim * order[i] + component] =
          owned.nth_index_in_set(static_cast<Dof>(dim * i + component));
  dof_handler.renumber_dofs(numbers);
}

template void number_by_neighbours(dealii::DoFHandler<2>&);
template void number_by_neighbours(dealii::DoFHandler<3>&);

}  // namespace geneva::fem
