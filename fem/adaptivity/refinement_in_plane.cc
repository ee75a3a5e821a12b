#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fem/adaptivity/refinement.h"
#include "fem/adaptivity/refinement_zone.h"

namespace geneva::fem {

namespace {

/// The contact zone is refined this far beyond its ends, as a share of its length.
constexpr double margin_of_length = 0.25;
/// The longest edge of one side of a contact zone is at most this many times as long as its
/// shortest.
constexpr double evenness = 1.7;
/// The target's shortest edge over the source's. Targets whose edges are two thirds of the source's
/// make its pressure alternate by 0.1 % of the peak, longer ones by 0.01 to 0.08 %; doc/theory.md,
/// 5.1. The range holds a factor of two, so that halving one side leads into it.
constexpr double least_ratio_of_sides = 0.87;
constexpr double greatest_ratio_of_sides = 1.75;

/// An edge of the contact zone, named by the dof of its start.
struct ZoneEdge {
  global_dof_index start;
  double length;
};

double edge_length(const Surface<2>& surface, const SurfaceFace<2>& face) {
  return surface.nodes[face.nodes[0]].position.distance(surface.nodes[face.nodes[1]].position);
}

/// Arc lengths of an edge's ends; the last edge of a closed surface ends at its beginning.
std::pair<double, double> span(const Surface<2>& surface, const SurfaceFace<2>& face) {
  const double from = surface.nodes[face.nodes[0]].arc_length;
  const double to = surface.nodes[face.nodes[1]].arc_length;
  return {from, to > from ? to : surface.length};
}

/// Edges of a surface within the margin of an interval of arc length.
void add_zone_edges(const Surface<2>& surface, const std::pair<double, double>& interval,
                    std::vector<ZoneEdge>& edges) {
  const auto [begin, end] = interval;
  double longest = 0.;
  const double slack = 1e-9 * surface.length;
  for (const SurfaceFace<2>& face : surface.faces) {
    const auto [from, to] = span(surface, face);
    if (from <= end + slack && to >= begin - slack) longest = std::max(longest, to - from);
  }
  // A little more than the margin: on even meshes a node may stand exactly at its end, and
  // round-off must not decide.
  const double margin = std::max(margin_of_length * (end - begin), 0.5 * longest) + 1e-3 * longest;
  for (const SurfaceFace<2>& face : surface.faces) {
    const auto [from, to] = span(surface, face);
    if (from < end + margin && to > begin - margin)
      edges.push_back({surface.nodes[face.nodes[0]].dofs[0], edge_length(surface, face)});
  }
}

/// Arc-length intervals of the target over the source nodes of the zone.
ArcIntervals target_intervals(const ContactInterface<2>& interface) {
  const std::vector<bool> in_zone = zone_rows(interface);
  ArcIntervals intervals;
  bool open = false;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    if (in_zone[i]) {
      if (!open) intervals.emplace_back(interface.target.length, 0.);
      for (const auto& [node, coupling] : interface.rows[i].coupling) {
        const double at = interface.target.nodes[node].arc_length;
        intervals.back().first = std::min(intervals.back().first, at);
        intervals.back().second = std::max(intervals.back().second, at);
      }
    }
    open = in_zone[i];
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
  for (const auto& interval : zone_intervals(interface))
    add_zone_edges(interface.source, interval, sides.source);
  for (const auto& interval : target_intervals(interface))
    add_zone_edges(interface.target, interval, sides.target);
  return sides;
}

/// Maximum lengths of edges that do not belong to the part.
struct Limits {
  double source, target;
};

Limits limits_of(const ZonePart part, const ZoneSides& sides) {
  const double source = shortest(sides.source), target = shortest(sides.target);
  switch (part) {
    case ZonePart::uneven:
      return {target < least_ratio_of_sides * source ? 0. : evenness * source,
              target > greatest_ratio_of_sides * source ? 0. : evenness * target};
    case ZonePart::longest: {
      const double limit = std::max(longest(sides.source), longest(sides.target)) / evenness;
      return {limit, limit};
    }
    case ZonePart::all:
      break;
  }
  return {0., 0.};
}

Zone zone_edges(const std::vector<ContactInterface<2>>& interfaces, const SurfaceIds& surface_ids,
                const ZonePart part) {
  Zone zone;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const ZoneSides sides = zone_sides(interfaces[i]);
    const Limits limits = limits_of(part, sides);
    add_longer(zone, surface_ids[i].first, sides.source, limits.source);
    add_longer(zone, surface_ids[i].second, sides.target, limits.target);
  }
  return zone;
}

unsigned int flag_edges(dealii::DoFHandler<2>& dof_handler, const Zone& zone) {
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

}  // namespace

unsigned int flag_zone(dealii::DoFHandler<2>& dof_handler,
                       const std::vector<ContactInterface<2>>& interfaces,
                       const SurfaceIds& surface_ids, const ZonePart part) {
  return flag_edges(dof_handler, zone_edges(interfaces, surface_ids, part));
}

double unevenness(const std::vector<ContactInterface<2>>& interfaces) {
  double maximum = 1.;
  for (const ContactInterface<2>& interface : interfaces) {
    const ZoneSides sides = zone_sides(interface);
    maximum = std::max(maximum, std::max(longest(sides.source), longest(sides.target)) /
                                    std::min(shortest(sides.source), shortest(sides.target)));
  }
  return maximum;
}

}  // namespace geneva::fem
