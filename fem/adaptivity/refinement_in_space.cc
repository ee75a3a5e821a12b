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

/// This rank's cells with a face of a boundary whose vertices include one of the nodes.
std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells_along(
    dealii::DoFHandler<3>& dof_handler, const unsigned int surface, const ZoneNodes& nodes) {
  std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || !cell->at_boundary()) continue;
    const auto is_in_zone = [&](const unsigned int face) {
      if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() != surface)
        return false;
      for (unsigned int vertex = 0; vertex < 4; ++vertex)
        if (nodes.count(cell->face(face)->vertex_dof_index(vertex, 0)) > 0) return true;
      return false;
    };
    const auto faces = cell->face_indices();
    if (std::any_of(faces.begin(), faces.end(), is_in_zone)) cells.push_back(cell);
  }
  return cells;
}

unsigned int flag_side(dealii::DoFHandler<3>& dof_handler, const unsigned int surface,
                       const ZoneNodes& nodes, const bool only_uneven) {
  const auto cells = cells_along(dof_handler, surface, nodes);
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
                       const SurfaceIds& surface_ids, const ZonePart part) {
  const bool only_uneven = part == ZonePart::uneven;
  unsigned int flagged = 0;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const ContactInterface<3>& interface = interfaces[i];
    // A contact without an open node has no width: its zone is the whole surface in any case.
    const auto margin =
        1 + static_cast<unsigned int>(margin_of_width * std::min(nodes_across(interface), 400U));
    flagged +=
        flag_side(dof_handler, surface_ids[i].first,
                  nodes_within(interface.source, active_nodes(interface), margin), only_uneven);
    flagged +=
        flag_side(dof_handler, surface_ids[i].second,
                  nodes_within(interface.target, coupled_nodes(interface), margin), only_uneven);
  }
  return flagged;
}

}  // namespace geneva::fem
