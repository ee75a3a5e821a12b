#include "fem/refinement.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "fem/refinement_zone.h"

namespace geneva::fem {

namespace {

/// Cells whose energy-norm indicator exceeds this share of the greatest one are refined.
constexpr double energy_share = 0.8;

template <int dim>
double shortest_edge(const Surface<dim>& surface, const SurfaceFace<dim>& face) {
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < face.nodes.size(); ++i)
    shortest =
        std::min(shortest, surface.nodes[face.nodes[i]].position.distance(
                               surface.nodes[face.nodes[(i + 1) % face.nodes.size()]].position));
  return shortest;
}

/// Edge of the square of the cell's area; in space the least of its extents, which may be long
/// along the contact.
template <int dim>
double size_of(const typename dealii::DoFHandler<dim>::active_cell_iterator& cell) {
  if constexpr (dim == 2) return std::sqrt(cell->measure());
  double size = std::numeric_limits<double>::max();
  for (unsigned int axis = 0; axis < dim; ++axis)
    size = std::min(size, cell->extent_in_direction(axis));
  return size;
}

/// A contact zone as seen from the cells around it.
template <int dim>
struct ZoneOutline {
  std::vector<dealii::Point<dim>> nodes;  ///< in contact
  double next_size;                       ///< edge length in the zone after this refinement
};

template <int dim>
std::vector<ZoneOutline<dim>> zone_outlines(const std::vector<ContactInterface<dim>>& interfaces) {
  std::vector<ZoneOutline<dim>> zones;
  for (const ContactInterface<dim>& interface : interfaces) {
    ZoneOutline<dim> zone{{}, 0.};
    const std::vector<bool> active = active_nodes(interface);
    double shortest = std::numeric_limits<double>::max();
    for (const SurfaceFace<dim>& face : interface.source.faces)
      if (std::any_of(face.nodes.begin(), face.nodes.end(),
                      [&](const unsigned int node) { return active[node]; }))
        shortest = std::min(shortest, shortest_edge(interface.source, face));
    for (std::size_t node = 0; node < active.size(); ++node)
      if (active[node]) zone.nodes.push_back(interface.source.nodes[node].position);
    zone.next_size = shortest / 2.;
    if (!zone.nodes.empty()) zones.push_back(zone);
  }
  return zones;
}

template <int dim>
unsigned int flag_surroundings(dealii::DoFHandler<dim>& dof_handler,
                               const std::vector<ContactInterface<dim>>& interfaces,
                               const double grading) {
  constexpr double slack = 1.1;  // cells are not quite square
  std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> large;
  for (const ZoneOutline<dim>& zone : zone_outlines(interfaces)) {
    const auto tree = dealii::pack_rtree(zone.nodes);
    for (const auto& cell : dof_handler.active_cell_iterators()) {
      if (!cell->is_locally_owned() || cell->refine_flag_set()) continue;
      const dealii::Point<dim> centre = cell->center();
      std::vector<dealii::Point<dim>> nearest;
      tree.query(boost::geometry::index::nearest(centre, 1), std::back_inserter(nearest));
      const double wanted = std::max(grading * centre.distance(nearest.front()), zone.next_size);
      if (size_of<dim>(cell) > slack * wanted) large.push_back(cell);
    }
  }
  unsigned int flagged = 0;
  for (const auto& cell : large) {
    if (cell->refine_flag_set()) continue;
    cell->set_refine_flag();
    ++flagged;
  }
  return flagged;
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

}  // namespace

template <int dim>
unsigned int flag_cells(dealii::DoFHandler<dim>& dof_handler,
                        const dealii::TrilinosWrappers::MPI::Vector& displacement,
                        const std::vector<ContactInterface<dim>>& interfaces,
                        const std::vector<std::pair<unsigned int, unsigned int>>& surface_ids,
                        const std::optional<double> grading) {
  unsigned int flagged = flag_zone(dof_handler, interfaces, surface_ids, false);
  if (grading) {
    flagged += flag_surroundings(dof_handler, interfaces, *grading);
    flagged += flag_energy(dof_handler, displacement);
  }
  return dealii::Utilities::MPI::sum(flagged, dof_handler.get_communicator());
}

template <int dim>
unsigned int flag_uneven_edges(dealii::DoFHandler<dim>& dof_handler,
                               const std::vector<ContactInterface<dim>>& interfaces,
                               const SurfaceIds& surface_ids) {
  return dealii::Utilities::MPI::sum(flag_zone(dof_handler, interfaces, surface_ids, true),
                                     dof_handler.get_communicator());
}

template unsigned int flag_cells(dealii::DoFHandler<2>&,
                                 const dealii::TrilinosWrappers::MPI::Vector&,
                                 const std::vector<ContactInterface<2>>&, const SurfaceIds&,
                                 std::optional<double>);
template unsigned int flag_uneven_edges(dealii::DoFHandler<2>&,
                                        const std::vector<ContactInterface<2>>&, const SurfaceIds&);
template unsigned int flag_cells(dealii::DoFHandler<3>&,
                                 const dealii::TrilinosWrappers::MPI::Vector&,
                                 const std::vector<ContactInterface<3>>&, const SurfaceIds&,
                                 std::optional<double>);
template unsigned int flag_uneven_edges(dealii::DoFHandler<3>&,
                                        const std::vector<ContactInterface<3>>&, const SurfaceIds&);

}  // namespace geneva::fem
