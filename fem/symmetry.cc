#include "fem/symmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace geneva::fem {

namespace {

/// Places on a plane agree to this share of the coordinates' size.
constexpr double rounding = 1e-9;

bool is_same(const double one, const double other, const double size) {
  return std::abs(one - other) <= rounding * size;
}

/// Lowest and highest coordinate of a surface's vertices along an axis.
template <int dim>
std::pair<double, double> extent(const mesh::MeshData<dim>& mesh, const unsigned int surface,
                                 const unsigned int axis) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const mesh::Face<dim>& face : mesh.faces)
    for (const unsigned int vertex : face.vertices)
      if (face.surface == surface) {
        lowest = std::min(lowest, mesh.vertices[vertex][axis]);
        highest = std::max(highest, mesh.vertices[vertex][axis]);
      }
  return {lowest, highest};
}

/// Planes normal to an axis on which supports hold a body in that direction only.
template <int dim>
std::vector<double> held_planes(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                const unsigned int body, const unsigned int axis,
                                const double size) {
  std::vector<double> planes;
  for (const Support<dim>& support : problem.supports) {
    bool is_sliding = true;
    for (unsigned int i = 0; i < dim; ++i)
      is_sliding = is_sliding && (i == axis ? support.displacement[i] == 0.
                                            : !support.displacement[i].has_value());
    const unsigned int surface = mesh::index_of(mesh.surfaces, support.surface);
    if (!is_sliding || mesh::bodies_of(mesh, surface).count(body) == 0) continue;
    const auto [lowest, highest] = extent(mesh, surface, axis);
    if (is_same(lowest, highest, size)) planes.push_back(lowest);
  }
  return planes;
}

}  // namespace

template <int dim>
std::optional<double> symmetry_plane(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                     const ContactResult<dim>& contact, const unsigned int axis) {
  if (contact.nodes.empty()) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(
      contact.nodes.begin(), contact.nodes.end(),
      [&](const auto& a, const auto& b) { return a.position[axis] < b.position[axis]; });
  double size = 0.;
  for (const auto& vertex : mesh.vertices)
    for (const double coordinate : vertex) size = std::max(size, std::abs(coordinate));
  const auto planes_of = [&](const std::string& surface) {
    const auto bodies = mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface));
    return held_planes(mesh, problem, *bodies.begin(), axis, size);
  };
  const std::vector<double> of_target = planes_of(contact.target);
  for (const double plane : planes_of(contact.source)) {
    const auto is_here = [&](const double other) { return is_same(other, plane, size); };
    if (std::any_of(of_target.begin(), of_target.end(), is_here) &&
        (is_here(lowest->position[axis]) || is_here(highest->position[axis])))
      return plane;
  }
  return std::nullopt;
}

template <int dim>
std::array<std::optional<double>, static_cast<std::size_t>(dim)> mirrors(
    const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
    const ContactResult<dim>& contact) {
  std::array<std::optional<double>, static_cast<std::size_t>(dim)> places;
  for (unsigned int axis = 0; axis < dim; ++axis)
    places[axis] = symmetry_plane(mesh, problem, contact, axis);
  if (dim == 2 && problem.plane == PlaneKind::axisymmetric) places[0] = 0.;
  return places;
}

template std::optional<double> symmetry_plane(const mesh::MeshData<2>&, const Problem<2>&,
                                              const ContactResult<2>&, unsigned int);
template std::optional<double> symmetry_plane(const mesh::MeshData<3>&, const Problem<3>&,
                                              const ContactResult<3>&, unsigned int);
template std::array<std::optional<double>, 2> mirrors(const mesh::MeshData<2>&, const Problem<2>&,
                                                      const ContactResult<2>&);
template std::array<std::optional<double>, 3> mirrors(const mesh::MeshData<3>&, const Problem<3>&,
                                                      const ContactResult<3>&);

}  // namespace geneva::fem
