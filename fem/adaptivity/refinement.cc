#include "fem/adaptivity/refinement.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "fem/adaptivity/force_error.h"
#include "fem/adaptivity/refinement_zone.h"
#include "fem/discretisation/cell_measure.h"

namespace geneva::fem {

namespace {

/// Cells whose energy-norm indicator exceeds this share of the maximum one are refined.
constexpr double energy_share = 0.8;

/// Cells are not quite square: by so much one may be longer than asked for.
constexpr double size_slack = 1.1;

template <int dim>
double shortest_edge(const Surface<dim>& surface, const SurfaceFace<dim>& face) {
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < face.nodes.size(); ++i)
    shortest =
        std::min(shortest, surface.nodes[face.nodes[i]].position.distance(
                               surface.nodes[face.nodes[(i + 1) % face.nodes.size()]].position));
  return shortest;
}

template <int dim>
double longest_edge(const Surface<dim>& surface, const SurfaceFace<dim>& face) {
  double longest = 0.;
  for (std::size_t i = 0; i < face.nodes.size(); ++i)
    longest =
        std::max(longest, surface.nodes[face.nodes[i]].position.distance(
                              surface.nodes[face.nodes[(i + 1) % face.nodes.size()]].position));
  return longest;
}

/// The longest extent of a cell; in 3-D the middle one, or the longest one over the elongation of
/// the zone's faces if that is more: where the contact needs no short cells along it, they are not
/// needed around it.
template <int dim>
double size_of(const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
               const double elongation) {
  Components<dim> extents{};
  for (unsigned int axis = 0; axis < dim; ++axis) extents[axis] = cell->extent_in_direction(axis);
  std::sort(extents.begin(), extents.end());
  if (dim == 2) return extents[1];
  return std::max(extents[1], extents[dim - 1] / elongation);
}

/// A contact as seen from the cells around it.
template <int dim>
struct ZoneOutline {
  std::vector<dealii::Point<dim>> nodes;  ///< in contact, of both sides: a gap may have been wide
  std::vector<double> sizes;              ///< of the edges at these nodes after this refinement
  double elongation;                      ///< maximum ratio of a face's edges in the zone
  double width;       ///< of the contact; in 3-D its edges times the nodes across
  double zone_width;  ///< without a smooth middle
};

/// Nodes of the target opposite to the chosen rows.
template <int dim>
std::vector<bool> opposite_nodes(const ContactInterface<dim>& interface,
                                 const std::vector<bool>& rows) {
  std::vector<bool> opposite(interface.target.nodes.size(), false);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i])
      for (const auto& [node, coupling] : interface.rows[i].coupling) opposite[node] = true;
  return opposite;
}

/// Sums up the lengths of edges, half at each of their ends, over the chosen nodes.
double length_of(const Surface<2>& surface, const std::vector<bool>& nodes) {
  double length = 0.;
  for (const SurfaceFace<2>& face : surface.faces)
    for (const unsigned int node : face.nodes)
      if (nodes[node]) length += longest_edge(surface, face) / 2.;
  return length;
}

/// The longest edge at each node of a surface.
std::vector<double> edges_at_nodes(const Surface<2>& surface) {
  std::vector<double> edges(surface.nodes.size(), 0.);
  for (const SurfaceFace<2>& face : surface.faces)
    for (const unsigned int node : face.nodes)
      edges[node] = std::max(edges[node], longest_edge(surface, face));
  return edges;
}

/// The longest edge at each node of source and target.
struct EdgesAtNodes {
  std::vector<double> source, target;
};

/// In the smooth middle both sides count as what the coarser one is there: else a cell of that side
/// would be refined for its finer neighbours over the gap, and then those for it, on every mesh.
EdgesAtNodes edges_at_nodes(const ContactInterface<2>& interface) {
  EdgesAtNodes edges{edges_at_nodes(interface.source), edges_at_nodes(interface.target)};
  const EdgesAtNodes own = edges;
  const std::vector<bool> in_zone = zone_rows(interface);
  for (std::size_t i = 0; i < in_zone.size(); ++i) {
    if (!is_closed(interface.status[i]) || in_zone[i]) continue;
    const unsigned int node = interface.rows[i].node;
    for (const auto& [opposite, coupling] : interface.rows[i].coupling) {
      edges.source[node] = std::max(edges.source[node], own.target[opposite]);
      edges.target[opposite] = std::max(edges.target[opposite], own.source[node]);
    }
  }
  return edges;
}

/// Adds a surface's nodes in contact; the edges of those in the zone shrink by a factor.
void add_nodes(ZoneOutline<2>& outline, const Surface<2>& surface, const std::vector<double>& edges,
               const std::vector<bool>& active, const std::vector<bool>& in_zone,
               const double factor) {
  for (std::size_t node = 0; node < active.size(); ++node)
    if (active[node]) {
      outline.nodes.push_back(surface.nodes[node].position);
      outline.sizes.push_back(edges[node] * (in_zone[node] ? factor : 1.));
    }
}

ZoneOutline<2> outline_of(const ContactInterface<2>& interface, const double factor) {
  const std::vector<bool> active = active_nodes(interface);
  const std::vector<bool> in_zone = zone_nodes(interface);
  const EdgesAtNodes edges = edges_at_nodes(interface);
  ZoneOutline<2> outline{
      {}, {}, 1., length_of(interface.source, active), length_of(interface.source, in_zone)};
  add_nodes(outline, interface.source, edges.source, active, in_zone, factor);
  add_nodes(outline, interface.target, edges.target,
            opposite_nodes(interface, closed(interface.status)),
            opposite_nodes(interface, zone_rows(interface)), factor);
  return outline;
}

ZoneOutline<3> outline_of(const ContactInterface<3>& interface, const double factor) {
  ZoneOutline<3> outline{{}, {}, 1., 0., 0.};
  const std::vector<bool> active = active_nodes(interface);
  double shortest = std::numeric_limits<double>::max();
  for (const SurfaceFace<3>& face : interface.source.faces)
    if (std::any_of(face.nodes.begin(), face.nodes.end(),
                    [&](const unsigned int node) { return active[node]; })) {
      const double edge = shortest_edge(interface.source, face);
      shortest = std::min(shortest, edge);
      outline.elongation =
          std::max(outline.elongation, longest_edge(interface.source, face) / edge);
    }
  const std::vector<bool> opposite = opposite_nodes(interface, closed(interface.status));
  for (std::size_t node = 0; node < active.size(); ++node)
    if (active[node]) outline.nodes.push_back(interface.source.nodes[node].position);
  for (std::size_t node = 0; node < opposite.size(); ++node)
    if (opposite[node]) outline.nodes.push_back(interface.target.nodes[node].position);
  outline.sizes.assign(outline.nodes.size(), shortest * factor);
  outline.width = outline.zone_width = nodes_across(interface) * shortest;
  return outline;
}

template <int dim>
std::vector<ZoneOutline<dim>> zone_outlines(const std::vector<ContactInterface<dim>>& interfaces,
                                            const bool zone_is_refined) {
  std::vector<ZoneOutline<dim>> zones;
  for (const ContactInterface<dim>& interface : interfaces) {
    const ZoneOutline<dim> outline = outline_of(interface, zone_is_refined ? 0.5 : 1.);
    if (!outline.nodes.empty()) zones.push_back(outline);
  }
  return zones;
}

/// Finds a contact's node that is next to a point.
template <int dim>
class NearestNode {
 public:
  explicit NearestNode(const ZoneOutline<dim>& zone)
      : tree_(dealii::pack_rtree_of_indices(zone.nodes)) {}

  [[nodiscard]] std::size_t operator()(const dealii::Point<dim>& point) const {
    std::vector<std::size_t> nearest;
    tree_.query(boost::geometry::index::nearest(point, 1), std::back_inserter(nearest));
    return nearest.front();
  }

 private:
  decltype(dealii::pack_rtree_of_indices(std::vector<dealii::Point<dim>>())) tree_;
};

/// What a cell is beside the contact's node next to it.
struct BesideZone {
  double distance;   ///< from the cell's centre
  double next_size;  ///< of the edges at that node
};

/// Calls a function for every cell of this rank and every zone.
template <int dim, typename Function>
void visit_cells(const dealii::DoFHandler<dim>& dof_handler,
                 const std::vector<ZoneOutline<dim>>& zones, const Function& visit) {
  for (const ZoneOutline<dim>& zone : zones) {
    const NearestNode<dim> nearest(zone);
    for (const auto& cell : dof_handler.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const dealii::Point<dim> centre = cell->center();
      const std::size_t node = nearest(centre);
      visit(cell, zone, BesideZone{centre.distance(zone.nodes[node]), zone.sizes[node]});
    }
  }
}

/// How the sizes of cells grow with their distance from a contact.
struct Sizes {
  double grading;
  double growth;  ///< see size_growth()
};

/// Maximum size of a cell at a distance from a contact.
template <int dim>
double size_at(const double distance, const ZoneOutline<dim>& zone, const Sizes& sizes) {
  const double even = 2. * zone.width;  // as far as stresses of the contact's own field matter
  return sizes.grading * distance * std::pow(std::max(1., distance / even), sizes.growth - 1.);
}

template <int dim>
unsigned int flag_surroundings(dealii::DoFHandler<dim>& dof_handler,
                               const std::vector<ZoneOutline<dim>>& zones, const Sizes& sizes) {
  unsigned int flagged = 0;
  visit_cells(
      dof_handler, zones,
      [&](const auto& cell, const ZoneOutline<dim>& zone, const BesideZone& beside) {
        const double wanted = std::max(size_at(beside.distance, zone, sizes), beside.next_size);
        if (cell->refine_flag_set() || size_of<dim>(cell, zone.elongation) <= size_slack * wanted)
          return;
        cell->set_refine_flag();
        ++flagged;
      });
  return flagged;
}

/// Cells with a refinement flag, which they lose.
template <int dim>
std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> unflagged(
    dealii::DoFHandler<dim>& dof_handler) {
  std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> cells;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->refine_flag_set()) {
      cell->clear_refine_flag();
      cells.push_back(cell);
    }
  return cells;
}

/// Outlines with sizes that no cell of the zone exceeds, and these cells.
template <int dim>
struct ZoneCells {
  std::vector<ZoneOutline<dim>> zones;
  std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> cells;
};

template <int dim>
ZoneCells<dim> zones_with_cells(dealii::DoFHandler<dim>& dof_handler,
                                const std::vector<ContactInterface<dim>>& interfaces,
                                const SurfaceIds& surface_ids) {
  flag_zone(dof_handler, interfaces, surface_ids, ZonePart::all);
  ZoneCells<dim> result{zone_outlines(interfaces, false), unflagged(dof_handler)};
  for (ZoneOutline<dim>& zone : result.zones) {
    const NearestNode<dim> nearest(zone);
    double factor = 1.;
    for (const auto& cell : result.cells)
      factor = std::max(factor,
                        size_of<dim>(cell, zone.elongation) / zone.sizes[nearest(cell->center())]);
    factor = dealii::Utilities::MPI::max(factor, dof_handler.get_communicator());
    for (double& size : zone.sizes) size *= factor;
  }
  return result;
}

template <int dim>
unsigned int flag_energy(dealii::DoFHandler<dim>& dof_handler, const Vector& displacement) {
  dealii::Vector<float> indicators(dof_handler.get_triangulation().n_active_cells());
  dealii::KellyErrorEstimator<dim>::estimate(dof_handler, dealii::QGauss<dim - 1>(2), {},
                                             displacement, indicators);
  const double maximum =
      dealii::Utilities::MPI::max(indicators.linfty_norm(), dof_handler.get_communicator());
  unsigned int flagged = 0;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && !cell->refine_flag_set() &&
        indicators[cell->active_cell_index()] > energy_share * maximum) {
      cell->set_refine_flag();
      ++flagged;
    }
  return flagged;
}

/// Flags cells around the zones, none of the zones, whose resolution would then change as well, and
/// none that is not larger than theirs.
template <int dim>
unsigned int flag_only_surroundings(dealii::DoFHandler<dim>& dof_handler,
                                    const Vector& displacement,
                                    const std::vector<ContactInterface<dim>>& interfaces,
                                    const SurfaceIds& surface_ids, const Sizes& sizes,
                                    const bool by_energy) {
  const auto [zones, zone_cells] = zones_with_cells(dof_handler, interfaces, surface_ids);
  unsigned int flagged = flag_surroundings(dof_handler, zones, sizes);
  if (by_energy) flagged += flag_energy(dof_handler, displacement);
  for (const auto& cell : zone_cells)
    if (cell->refine_flag_set()) {
      cell->clear_refine_flag();
      --flagged;
    }
  return flagged;
}

}  // namespace

template <int dim>
unsigned int flag_cells(dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                        const std::vector<ContactInterface<dim>>& interfaces,
                        const SurfaceIds& surface_ids, const Wanted& wanted) {
  unsigned int flagged = 0;
  if (wanted.zone) {
    flagged += flag_zone(dof_handler, interfaces, surface_ids, ZonePart::all);
    if (wanted.grading) {
      flagged += flag_surroundings(dof_handler, zone_outlines(interfaces, true),
                                   {*wanted.grading, wanted.growth});
      flagged += flag_energy(dof_handler, displacement);
    }
  } else if (wanted.grading) {
    flagged += flag_only_surroundings(dof_handler, displacement, interfaces, surface_ids,
                                      {*wanted.grading, wanted.growth}, wanted.by_energy);
  }
  return dealii::Utilities::MPI::sum(flagged, dof_handler.get_communicator());
}

template <int dim>
int size_decay(const Problem<dim>& problem) {
  if (dim == 3) return 4;
  const int of_given_force = problem.plane == PlaneKind::axisymmetric ? 7 : 6;
  return force_is_known(problem) ? of_given_force : of_given_force - 2;
}

template <int dim>
double size_growth(const Problem<dim>& problem) {
  return dim == 3 || has_prescribed_displacement(problem) ? 1. : 1.5;
}

template <int dim>
double size_measure(dealii::DoFHandler<dim>& dof_handler,
                    const std::vector<ContactInterface<dim>>& interfaces,
                    const SurfaceIds& surface_ids, const int decay) {
  double sum = 0.;
  visit_cells(dof_handler, zones_with_cells(dof_handler, interfaces, surface_ids).zones,
              [&](const auto& cell, const ZoneOutline<dim>& zone, const BesideZone& beside) {
                const double size = size_of<dim>(cell, zone.elongation);
                if (size > size_slack * beside.next_size)
                  sum += size * size * cell_measure<dim>(cell) /
                         std::pow(std::max(beside.distance, zone.zone_width / 2.), decay);
              });
  return dealii::Utilities::MPI::sum(sum, dof_handler.get_communicator());
}

template <int dim>
unsigned int flag_zone_part(dealii::DoFHandler<dim>& dof_handler,
                            const std::vector<ContactInterface<dim>>& interfaces,
                            const SurfaceIds& surface_ids, const ZonePart part) {
  return dealii::Utilities::MPI::sum(flag_zone(dof_handler, interfaces, surface_ids, part),
                                     dof_handler.get_communicator());
}

template unsigned int flag_cells(dealii::DoFHandler<2>&, const Vector&,
                                 const std::vector<ContactInterface<2>>&, const SurfaceIds&,
                                 const Wanted&);
template int size_decay(const Problem<2>&);
template int size_decay(const Problem<3>&);
template double size_growth(const Problem<2>&);
template double size_growth(const Problem<3>&);
template double size_measure(dealii::DoFHandler<2>&, const std::vector<ContactInterface<2>>&,
                             const SurfaceIds&, int);
template double size_measure(dealii::DoFHandler<3>&, const std::vector<ContactInterface<3>>&,
                             const SurfaceIds&, int);
template unsigned int flag_zone_part(dealii::DoFHandler<2>&,
                                     const std::vector<ContactInterface<2>>&, const SurfaceIds&,
                                     ZonePart);
template unsigned int flag_cells(dealii::DoFHandler<3>&, const Vector&,
                                 const std::vector<ContactInterface<3>>&, const SurfaceIds&,
                                 const Wanted&);
template unsigned int flag_zone_part(dealii::DoFHandler<3>&,
                                     const std::vector<ContactInterface<3>>&, const SurfaceIds&,
                                     ZonePart);

}  // namespace geneva::fem
