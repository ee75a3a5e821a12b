#include "fem/refinement.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace geneva::fem {

namespace {

/// The contact zone is refined this far beyond its ends, as a share of its length.
constexpr double zone_margin = 0.25;
/// Cells whose energy-norm indicator exceeds this share of the greatest one are refined.
constexpr double energy_share = 0.8;
/// The longest edge of a contact zone is at most this many times as long as the shortest, on both
/// sides together.
constexpr double evenness = 1.7;

/// An edge of the contact zone, named by the dof of its start.
struct ZoneEdge {
  global_dof_index start;
  double length;
};

double edge_length(const Surface<2>& surface, const SurfaceFace<2>& face) {
  return surface.nodes[face.nodes[0]].position.distance(surface.nodes[face.nodes[1]].position);
}

/// Edges of a surface within the margin of an interval of arc length.
void add_zone_edges(const Surface<2>& surface, const std::pair<double, double>& interval,
                    std::vector<ZoneEdge>& edges) {
  const auto [begin, end] = interval;
  const auto span = [&](const SurfaceFace<2>& face) {
    const double from = surface.nodes[face.nodes[0]].arc_length;
    return std::pair{from, from + edge_length(surface, face)};
  };
  double longest = 0.;
  const double slack = 1e-9 * surface.length;
  for (const SurfaceFace<2>& face : surface.faces) {
    const auto [from, to] = span(face);
    if (from <= end + slack && to >= begin - slack) longest = std::max(longest, to - from);
  }
  // A little more than the margin: on even meshes a node may stand exactly at its end, and
  // round-off must not decide.
  const double margin = std::max(zone_margin * (end - begin), 0.5 * longest) + 1e-3 * longest;
  for (const SurfaceFace<2>& face : surface.faces) {
    const auto [from, to] = span(face);
    if (from < end + margin && to > begin - margin)
      edges.push_back({surface.nodes[face.nodes[0]].dofs[0], to - from});
  }
}

/// Arc-length intervals of the target over the active source nodes.
std::vector<std::pair<double, double>> target_intervals(const ContactInterface<2>& interface) {
  std::vector<std::pair<double, double>> intervals;
  bool open = false;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    if (interface.active[i]) {
      if (!open) intervals.emplace_back(interface.target.length, 0.);
      for (const auto& [node, coupling] : interface.rows[i].coupling) {
        const double at = interface.target.nodes[node].arc_length;
        intervals.back().first = std::min(intervals.back().first, at);
        intervals.back().second = std::max(intervals.back().second, at);
      }
    }
    open = interface.active[i];
  }
  return intervals;
}

using Zone = std::set<std::pair<unsigned int, global_dof_index>>;  ///< (boundary id, dof of the
                                                                   ///< edge's start)

double shortest(const std::vector<ZoneEdge>& edges) {
  double length = std::numeric_limits<double>::max();
  for (const ZoneEdge& edge : edges) length = std::min(length, edge.length);
  return length;
}

double longest(const std::vector<ZoneEdge>& edges) {
  double length = 0.;
  for (const ZoneEdge& edge : edges) length = std::max(length, edge.length);
  return length;
}

void add_longer(Zone& zone, const unsigned int surface_id, const std::vector<ZoneEdge>& edges,
                const double limit) {
  for (const ZoneEdge& edge : edges)
    if (edge.length > limit) zone.emplace(surface_id, edge.start);
}

/// The edges of one contact's zone.
struct ZoneSides {
  std::vector<ZoneEdge> source;
  std::vector<ZoneEdge> target;
};

ZoneSides zone_sides(const ContactInterface<2>& interface) {
  ZoneSides sides;
  for (const auto& interval : active_intervals(interface))
    add_zone_edges(interface.source, interval, sides.source);
  for (const auto& interval : target_intervals(interface))
    add_zone_edges(interface.target, interval, sides.target);
  return sides;
}

/// @param only_uneven only edges that are long for their zone
Zone zone_edges(const std::vector<ContactInterface<2>>& interfaces,
                const std::vector<std::pair<unsigned int, unsigned int>>& surface_ids,
                const bool only_uneven) {
  Zone zone;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const ZoneSides sides = zone_sides(interfaces[i]);
    const double limit =
        only_uneven ? evenness * std::min(shortest(sides.source), shortest(sides.target)) : 0.;
    add_longer(zone, surface_ids[i].first, sides.source, limit);
    add_longer(zone, surface_ids[i].second, sides.target, limit);
  }
  return zone;
}

unsigned int flag_zone(dealii::DoFHandler<2>& dof_handler, const Zone& zone) {
  unsigned int flagged = 0;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || !cell->at_boundary()) continue;
    for (const unsigned int face : cell->face_indices()) {
      if (!cell->face(face)->at_boundary() || cell->refine_flag_set()) continue;
      const unsigned int start =
          dealii::GeometryInfo<2>::face_to_cell_vertices(face, face == 1 || face == 2 ? 0 : 1);
      if (zone.count({cell->face(face)->boundary_id(), cell->vertex_dof_index(start, 0)}) > 0) {
        cell->set_refine_flag();
        ++flagged;
      }
    }
  }
  return flagged;
}

/// A contact zone as seen from the cells around it.
struct ZoneOutline {
  std::vector<dealii::Point<2>> nodes;  ///< in contact
  double next_size;                     ///< edge length in the zone after this refinement
};

std::vector<ZoneOutline> zone_outlines(const std::vector<ContactInterface<2>>& interfaces) {
  std::vector<ZoneOutline> zones;
  for (const ContactInterface<2>& interface : interfaces) {
    ZoneOutline zone{{}, 0.};
    std::set<unsigned int> active;
    for (std::size_t i = 0; i < interface.rows.size(); ++i)
      if (interface.active[i]) active.insert(interface.rows[i].node);
    double shortest = std::numeric_limits<double>::max();
    for (const SurfaceFace<2>& face : interface.source.faces)
      if (active.count(face.nodes[0]) + active.count(face.nodes[1]) > 0)
        shortest = std::min(shortest, edge_length(interface.source, face));
    for (const unsigned int node : active)
      zone.nodes.push_back(interface.source.nodes[node].position);
    zone.next_size = shortest / 2.;
    if (!zone.nodes.empty()) zones.push_back(zone);
  }
  return zones;
}

/// The largest size that a cell at a place should have.
double wanted_size(const std::vector<ZoneOutline>& zones, const double grading,
                   const dealii::Point<2>& place) {
  double size = std::numeric_limits<double>::max();
  for (const ZoneOutline& zone : zones) {
    double distance = std::numeric_limits<double>::max();
    for (const dealii::Point<2>& node : zone.nodes)
      distance = std::min(distance, place.distance(node));
    size = std::min(size, std::max(grading * distance, zone.next_size));
  }
  return size;
}

unsigned int flag_surroundings(dealii::DoFHandler<2>& dof_handler,
                               const std::vector<ContactInterface<2>>& interfaces,
                               const double grading) {
  constexpr double slack = 1.1;  // cells are not quite square
  const std::vector<ZoneOutline> zones = zone_outlines(interfaces);
  unsigned int flagged = 0;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && !cell->refine_flag_set() &&
        std::sqrt(cell->measure()) > slack * wanted_size(zones, grading, cell->center())) {
      cell->set_refine_flag();
      ++flagged;
    }
  return flagged;
}

unsigned int flag_energy(dealii::DoFHandler<2>& dof_handler,
                         const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  dealii::Vector<float> indicators(dof_handler.get_triangulation().n_active_cells());
  dealii::KellyErrorEstimator<2>::estimate(dof_handler, dealii::QGauss<1>(2), {}, displacement,
                                           indicators);
  const double greatest =
      dealii::Utilities::MPI::max(indicators.linfty_norm(), dof_handler.get_communicator());
  unsigned int flagged = 0;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && !cell->refine_flag_set() &&
        indicators[cell->active_cell_index()] > energy_share * greatest) {
      cell->set_refine_flag();
      ++flagged;
    }
  return flagged;
}

}  // namespace

unsigned int flag_cells(dealii::DoFHandler<2>& dof_handler,
                        const dealii::TrilinosWrappers::MPI::Vector& displacement,
                        const std::vector<ContactInterface<2>>& interfaces,
                        const std::vector<std::pair<unsigned int, unsigned int>>& surface_ids,
                        const std::optional<double> grading) {
  unsigned int flagged = flag_zone(dof_handler, zone_edges(interfaces, surface_ids, false));
  if (grading) {
    flagged += flag_surroundings(dof_handler, interfaces, *grading);
    flagged += flag_energy(dof_handler, displacement);
  }
  return dealii::Utilities::MPI::sum(flagged, dof_handler.get_communicator());
}

double unevenness(const std::vector<ContactInterface<2>>& interfaces) {
  double greatest = 1.;
  for (const ContactInterface<2>& interface : interfaces) {
    const ZoneSides sides = zone_sides(interface);
    greatest = std::max(greatest, std::max(longest(sides.source), longest(sides.target)) /
                                      std::min(shortest(sides.source), shortest(sides.target)));
  }
  return greatest;
}

unsigned int flag_uneven_edges(
    dealii::DoFHandler<2>& dof_handler, const std::vector<ContactInterface<2>>& interfaces,
    const std::vector<std::pair<unsigned int, unsigned int>>& surface_ids) {
  const unsigned int flagged = flag_zone(dof_handler, zone_edges(interfaces, surface_ids, true));
  return dealii::Utilities::MPI::sum(flagged, dof_handler.get_communicator());
}

}  // namespace geneva::fem
