#include "fem/discretisation/saved_field.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"
#include "fem/discretisation/gather.h"

namespace geneva::fem {

namespace {

using dealii::types::global_dof_index;

/// A cell as it travels: its corners are named by their first unknown.
template <int dim>
struct TravellingCell {
  CellName name;
  std::array<global_dof_index, SavedField<dim>::corners> corners;
};

/// A corner and its displacement.
template <int dim>
struct TravellingNode {
  global_dof_index name;
  std::array<double, static_cast<std::size_t>(dim)> displacement;
};

[[noreturn]] void refuse_field(const std::string& what) {
  throw base::InputError("the checkpoint does not fit this case or is damaged: " + what);
}

template <typename Cell>
CellName name_of(const Cell& cell) {
  return cell->id().template to_binary<Cell::AccessorType::dimension>();
}

template <int dim>
std::vector<TravellingCell<dim>> own_cells(const dealii::DoFHandler<dim>& dof_handler) {
  std::vector<TravellingCell<dim>> cells;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    TravellingCell<dim> own{name_of(cell), {}};
    for (const unsigned int i : cell->vertex_indices())
      own.corners[i] = cell->vertex_dof_index(i, 0);
    cells.push_back(own);
  }
  return cells;
}

template <int dim>
std::vector<TravellingNode<dim>> own_nodes(const dealii::DoFHandler<dim>& dof_handler,
                                           const Vector& displacement) {
  std::vector<TravellingNode<dim>> nodes;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int i : cell->vertex_indices()) {
      TravellingNode<dim> own{cell->vertex_dof_index(i, 0), {}};
      for (unsigned int component = 0; component < dim; ++component)
        own.displacement[component] = displacement(cell->vertex_dof_index(i, component));
      nodes.push_back(own);
    }
  }
  return nodes;
}

/// In ascending order of their names, each once.
template <int dim>
void make_unique(std::vector<TravellingNode<dim>>& nodes) {
  std::sort(nodes.begin(), nodes.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  const auto end = std::unique(nodes.begin(), nodes.end(),
                               [](const auto& a, const auto& b) { return a.name == b.name; });
  nodes.erase(end, nodes.end());
}

template <int dim>
unsigned int index_of(const std::vector<TravellingNode<dim>>& nodes, const global_dof_index name) {
  const auto found =
      std::lower_bound(nodes.begin(), nodes.end(), name,
                       [](const auto& node, const auto& wanted) { return node.name < wanted; });
  return static_cast<unsigned int>(found - nodes.begin());
}

/// The place of a cell in the saved ones; their number if it is none of them.
template <int dim>
std::size_t place_of(const SavedField<dim>& saved, const CellName& name) {
  const auto found = std::lower_bound(saved.cells.begin(), saved.cells.end(), name);
  if (found == saved.cells.end() || *found != name) return saved.cells.size();
  return static_cast<std::size_t>(found - saved.cells.begin());
}

/// Flags this rank's cells that are not among the saved ones: all of these must be finer.
/// @return whether any rank has such cells
template <int dim>
bool flag_coarser(dealii::parallel::distributed::Triangulation<dim>& triangulation,
                  const SavedField<dim>& saved) {
  unsigned int is_any = 0;
  for (const auto& cell : triangulation.active_cell_iterators()) {
    if (!cell->is_locally_owned() || place_of(saved, name_of(cell)) < saved.cells.size()) continue;
    cell->set_refine_flag();
    is_any = 1;
  }
  return dealii::Utilities::MPI::max(is_any, triangulation.get_communicator()) == 1;
}

}  // namespace

template <int dim>
SavedField<dim> saved_field(const dealii::DoFHandler<dim>& dof_handler,
                            const Vector& displacement) {
  const MPI_Comm communicator = dof_handler.get_communicator();
  auto cells = gathered(communicator, own_cells(dof_handler));
  auto own = own_nodes(dof_handler, displacement);
  make_unique(own);
  auto nodes = gathered(communicator, own);
  make_unique(nodes);
  std::sort(cells.begin(), cells.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  SavedField<dim> saved;
  for (const TravellingCell<dim>& cell : cells) {
    saved.cells.push_back(cell.name);
    for (const global_dof_index corner : cell.corners)
      saved.nodes.push_back(index_of(nodes, corner));
  }
  for (const TravellingNode<dim>& node : nodes)
    saved.displacement.insert(saved.displacement.end(), node.displacement.begin(),
                              node.displacement.end());
  return saved;
}

template <int dim>
void refine_as(dealii::parallel::distributed::Triangulation<dim>& triangulation,
               const SavedField<dim>& saved) {
  // every round has more cells: with a wrong list it ends, too
  while (triangulation.n_global_active_cells() <= saved.cells.size() &&
         flag_coarser(triangulation, saved)) {
    triangulation.prepare_coarsening_and_refinement();
    triangulation.execute_coarsening_and_refinement();
    triangulation.repartition();
  }
  if (triangulation.n_global_active_cells() != saved.cells.size())
    refuse_field("its cells are not those of the coarse mesh");
}

template <int dim>
Vector field_on(const dealii::DoFHandler<dim>& dof_handler, const SavedField<dim>& saved) {
  Vector field(dof_handler.locally_owned_dofs(), dof_handler.get_communicator());
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const std::size_t place = place_of(saved, name_of(cell));
    for (const unsigned int i : cell->vertex_indices()) {
      const std::size_t node = saved.nodes[place * SavedField<dim>::corners + i];
      for (unsigned int component = 0; component < dim; ++component) {
        const global_dof_index dof = cell->vertex_dof_index(i, component);
        if (dof_handler.locally_owned_dofs().is_element(dof))
          field(dof) = saved.displacement[node * dim + component];
      }
    }
  }
  field.compress(dealii::VectorOperation::insert);
  return field;
}

template <int dim>
void check(const SavedField<dim>& saved) {
  const auto& [cells, nodes, displacement] = saved;
  if (cells.empty() ||
      std::adjacent_find(cells.begin(), cells.end(), std::greater_equal<>()) != cells.end())
    refuse_field("its cells are not in order");
  if (nodes.size() != cells.size() * SavedField<dim>::corners || displacement.size() % dim != 0 ||
      std::any_of(nodes.begin(), nodes.end(),
                  [&](const unsigned int node) { return node >= saved.n_nodes(); }))
    refuse_field("its cells have no such nodes");
  if (!std::all_of(displacement.begin(), displacement.end(),
                   [](const double value) { return std::isfinite(value); }))
    refuse_field("a displacement is not finite");
}

template SavedField<2> saved_field(const dealii::DoFHandler<2>&, const Vector&);
template SavedField<3> saved_field(const dealii::DoFHandler<3>&, const Vector&);
template void refine_as(dealii::parallel::distributed::Triangulation<2>&, const SavedField<2>&);
template void refine_as(dealii::parallel::distributed::Triangulation<3>&, const SavedField<3>&);
template Vector field_on(const dealii::DoFHandler<2>&, const SavedField<2>&);
template Vector field_on(const dealii::DoFHandler<3>&, const SavedField<3>&);
template void check(const SavedField<2>&);
template void check(const SavedField<3>&);

}  // namespace geneva::fem
