#include "fem/refinement.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include "fem/refinement_zone.h"

namespace geneva::fem {

namespace {

/// Cells whose energy-norm indicator exceeds this share of the greatest one are refined.
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

/// The longest extent of a cell; in space the middle one, or the longest one over the elongation of
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

/// A contact zone as seen from the cells around it.
template <int dim>
struct ZoneOutline {
  std::vector<dealii::Point<dim>> nodes;  ///< in contact, of both sides: a gap may have been wide
  double next_size;                       ///< edge length in the zone after this refinement
  double elongation;                      ///< greatest ratio of a face's edges in the zone
  double width;  ///< of the contact; in space its edges times the nodes across
};

template <int dim>
void add_target_nodes(const ContactInterface<dim>& interface,
                      std::vector<dealii::Point<dim>>& nodes) {
  const std::vector<bool> in_zone = zone_rows(interface);
  std::set<std::size_t> opposite;
  for (std::size_t i = 0; i < in_zone.size(); ++i)
    if (in_zone[i])
      for (const auto& [node, coupling] : interface.rows[i].coupling) opposite.insert(node);
  for (const std::size_t node : opposite) nodes.push_back(interface.target.nodes[node].position);
}

template <int dim>
std::vector<ZoneOutline<dim>> zone_outlines(const std::vector<ContactInterface<dim>>& interfaces,
                                            const bool zone_is_refined) {
  std::vector<ZoneOutline<dim>> zones;
  for (const ContactInterface<dim>& interface : interfaces) {
    ZoneOutline<dim> zone{{}, 0., 1., 0.};
    const std::vector<bool> in_zone = zone_nodes(interface);
    double shortest = std::numeric_limits<double>::max();
    for (const SurfaceFace<dim>& face : interface.source.faces)
      if (std::any_of(face.nodes.begin(), face.nodes.end(),
                      [&](const unsigned int node) { return in_zone[node]; })) {
        const double edge = shortest_edge(interface.source, face);
        shortest = std::min(shortest, edge);
        zone.elongation = std::max(zone.elongation, longest_edge(interface.source, face) / edge);
      }
    for (std::size_t node = 0; node < in_zone.size(); ++node)
      if (in_zone[node]) zone.nodes.push_back(interface.source.nodes[node].position);
    const std::size_t across_source = zone.nodes.size();
    add_target_nodes(interface, zone.nodes);
    zone.next_size = zone_is_refined ? shortest / 2. : shortest;
    const auto across =
        dim == 2 ? across_source : static_cast<std::size_t>(nodes_across(interface));
    zone.width = static_cast<double>(across) * shortest;
    if (!zone.nodes.empty()) zones.push_back(zone);
  }
  return zones;
}

/// Calls a function for every cell of this rank and every zone with the distance of the two.
template <int dim, typename Function>
void visit_cells(const dealii::DoFHandler<dim>& dof_handler,
                 const std::vector<ZoneOutline<dim>>& zones, const Function& visit) {
  for (const ZoneOutline<dim>& zone : zones) {
    const auto tree = dealii::pack_rtree(zone.nodes);
    for (const auto& cell : dof_handler.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const dealii::Point<dim> centre = cell->center();
      std::vector<dealii::Point<dim>> nearest;
      tree.query(boost::geometry::index::nearest(centre, 1), std::back_inserter(nearest));
      visit(cell, zone, centre.distance(nearest.front()));
    }
  }
}

/// Greatest size of a cell at a distance from a contact.
template <int dim>
double size_at(const double distance, const ZoneOutline<dim>& zone, const double grading) {
  const double even = 2. * zone.width;  // as far as stresses of the contact's own field matter
  if (dim == 3 || distance < even) return grading * distance;
  return grading * distance * std::sqrt(distance / even);
}

template <int dim>
unsigned int flag_surroundings(dealii::DoFHandler<dim>& dof_handler,
                               const std::vector<ZoneOutline<dim>>& zones, const double grading) {
  unsigned int flagged = 0;
  visit_cells(
      dof_handler, zones,
      [&](const auto& cell, const ZoneOutline<dim>& zone, const double distance) {
        const double wanted = std::max(size_at(distance, zone, grading), zone.next_size);
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

/// Outlines whose size is that of the zones' greatest cells, and these cells.
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
    for (const auto& cell : result.cells)
      zone.next_size = std::max(zone.next_size, size_of<dim>(cell, zone.elongation));
    zone.next_size = dealii::Utilities::MPI::max(zone.next_size, dof_handler.get_communicator());
  }
  return result;
}

template <int dim>
unsigned int flag_energy(dealii::DoFHandler<dim>& dof_handler,
                         const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  dealii::Vector<float> indicators(dof_handler.get_triangulation().n_active_cells());
  dealii::KellyErrorEstimator<dim>::estimate(dof_handler, dealii::QGauss<dim - 1>(2), {},
                                             displacement, indicators);
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

/// Flags cells around the zones, none of the zones, whose resolution would then change as well, and
/// none that is not larger than theirs.
template <int dim>
unsigned int flag_only_surroundings(dealii::DoFHandler<dim>& dof_handler,
                                    const dealii::TrilinosWrappers::MPI::Vector& displacement,
                                    const std::vector<ContactInterface<dim>>& interfaces,
                                    const SurfaceIds& surface_ids, const double grading) {
  const auto [zones, zone_cells] = zones_with_cells(dof_handler, interfaces, surface_ids);
  unsigned int flagged = flag_surroundings(dof_handler, zones, grading);
  flagged += flag_energy(dof_handler, displacement);
  for (const auto& cell : zone_cells)
    if (cell->refine_flag_set()) {
      cell->clear_refine_flag();
      --flagged;
    }
  return flagged;
}

}  // namespace

template <int dim>
unsigned int flag_cells(dealii::DoFHandler<dim>& dof_handler,
                        const dealii::TrilinosWrappers::MPI::Vector& displacement,
                        const std::vector<ContactInterface<dim>>& interfaces,
                        const SurfaceIds& surface_ids, const Wanted& wanted) {
  unsigned int flagged = 0;
  if (wanted.zone) {
    flagged += flag_zone(dof_handler, interfaces, surface_ids, ZonePart::all);
    if (wanted.grading) {
      flagged += flag_surroundings(dof_handler, zone_outlines(interfaces, true), *wanted.grading);
      flagged += flag_energy(dof_handler, displacement);
    }
  } else if (wanted.grading) {
    flagged +=
        flag_only_surroundings(dof_handler, displacement, interfaces, surface_ids, *wanted.grading);
  }
  return dealii::Utilities::MPI::sum(flagged, dof_handler.get_communicator());
}

template <int dim>
int size_decay(const Problem<dim>& problem) {
  if (dim == 3) return 4;
  const int of_given_force = problem.plane == PlaneKind::axisymmetric ? 7 : 6;
  return has_prescribed_displacement(problem) ? of_given_force - 2 : of_given_force;
}

template <int dim>
double size_measure(dealii::DoFHandler<dim>& dof_handler,
                    const std::vector<ContactInterface<dim>>& interfaces,
                    const SurfaceIds& surface_ids, const int decay) {
  double sum = 0.;
  visit_cells(dof_handler, zones_with_cells(dof_handler, interfaces, surface_ids).zones,
              [&](const auto& cell, const ZoneOutline<dim>& zone, const double distance) {
                const double size = size_of<dim>(cell, zone.elongation);
                if (size > size_slack * zone.next_size)
                  sum += size * size * cell->measure() /
                         std::pow(std::max(distance, zone.width / 2.), decay);
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

template unsigned int flag_cells(dealii::DoFHandler<2>&,
                                 const dealii::TrilinosWrappers::MPI::Vector&,
                                 const std::vector<ContactInterface<2>>&, const SurfaceIds&,
                                 const Wanted&);
template int size_decay(const Problem<2>&);
template int size_decay(const Problem<3>&);
template double size_measure(dealii::DoFHandler<2>&, const std::vector<ContactInterface<2>>&,
                             const SurfaceIds&, int);
template double size_measure(dealii::DoFHandler<3>&, const std::vector<ContactInterface<3>>&,
                             const SurfaceIds&, int);
template unsigned int flag_zone_part(dealii::DoFHandler<2>&,
                                     const std::vector<ContactInterface<2>>&, const SurfaceIds&,
                                     ZonePart);
template unsigned int flag_cells(dealii::DoFHandler<3>&,
                                 const dealii::TrilinosWrappers::MPI::Vector&,
                                 const std::vector<ContactInterface<3>>&, const SurfaceIds&,
                                 const Wanted&);
template unsigned int flag_zone_part(dealii::DoFHandler<3>&,
                                     const std::vector<ContactInterface<3>>&, const SurfaceIds&,
                                     ZonePart);

}  // namespace geneva::fem
