#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

#include "fem/adaptivity/refinement_zone.h"
#include "fem/contact/surface_in_space.h"

namespace geneva::fem {

namespace {

/// The zone reaches this share of the contact's width beyond it.
constexpr double margin_of_width = 0.25;

/// First unknowns of the nodes of one side's zone.
using ZoneNodes = std::set<global_dof_index>;

ZoneNodes nodes_within(const Surface<3>& surface, const std::vector<bool>& active,
                       const unsigned int steps) {
  const std::vector<unsigned int> distance = steps_from(surface, active);
  ZoneNodes nodes;
  for (std::size_t node = 0; node < distance.size(); ++node)
    if (distance[node] <= steps) nodes.insert(surface.nodes[node].dofs[0]);
  return nodes;
}

/// Target nodes that active rows are coupled with.
std::vector<bool> coupled_nodes(const ContactInterface<3>& interface) {
  std::vector<bool> coupled(interface.target.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (is_closed(interface.status[i]))
      for (const auto& [node, coupling] : interface.rows[i].coupling) coupled[node] = true;
  return coupled;
}

/// First unknowns of all nodes of one side, and of those in its zone.
struct SideNodes {
  ZoneNodes all;
  ZoneNodes zone;
};

SideNodes side_nodes(const Surface<3>& surface, const std::vector<bool>& active,
                     const unsigned int steps) {
  SideNodes nodes{{}, nodes_within(surface, active, steps)};
  for (const SurfaceNode<3>& node : surface.nodes) nodes.all.insert(node.dofs[0]);
  return nodes;
}

/// This rank's cells with an edge between two nodes of a surface, of which one at least is in the
/// zone. A cell that has no face there, as tetrahedra leave them, would make hanging nodes of its
/// edge's if it stayed coarse.
std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells_along(
    dealii::DoFHandler<3>& dof_handler, const SideNodes& nodes) {
  std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto is_in_zone = [&](const unsigned int line) {
      const auto one = cell->line(line)->vertex_dof_index(0, 0);
      const auto other = cell->line(line)->vertex_dof_index(1, 0);
      return nodes.all.count(one) > 0 && nodes.all.count(other) > 0 &&
             (nodes.zone.count(one) > 0 || nodes.zone.count(other) > 0);
    };
    const auto lines = cell->line_indices();
    if (std::any_of(lines.begin(), lines.end(), is_in_zone)) cells.push_back(cell);
  }
  return cells;
}

unsigned int flag_side(dealii::DoFHandler<3>& dof_handler, const SideNodes& nodes,
                       const bool only_uneven) {
  const auto cells = cells_along(dof_handler, nodes);
  int highest = 0;
  for (const auto& cell : cells) highest = std::max(highest, cell->level());
  highest = dealii::Utilities::MPI::max(highest, dof_handler.get_communicator());
  unsigned int flagged = 0;
  for (const auto& cell : cells) {
    if (cell->refine_flag_set() || (only_uneven && cell->level() == highest)) continue;
    cell->set_refine_flag();
    ++flagged;
  }
  return flagged;
}

}  // namespace

unsigned int flag_zone(dealii::DoFHandler<3>& dof_handler,
                       const std::vector<ContactInterface<3>>& interfaces,
                       const SurfaceIds& /*surface_ids*/, const ZonePart part) {
  const bool only_uneven = part == ZonePart::uneven;
  unsigned int flagged = 0;
  for (const ContactInterface<3>& interface : interfaces) {
    // A contact without an open node has no width: its zone is the whole surface in any case.
    const auto margin =
        1 + static_cast<unsigned int>(margin_of_width * std::min(nodes_across(interface), 400U));
    flagged += flag_side(dof_handler, side_nodes(interface.source, active_nodes(interface), margin),
                         only_uneven);
    flagged += flag_side(
        dof_handler, side_nodes(interface.target, coupled_nodes(interface), margin), only_uneven);
  }
  return flagged;
}

}  // namespace geneva::fem
