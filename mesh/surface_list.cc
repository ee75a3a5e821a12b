#include "mesh/surface_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace geneva::mesh {

namespace {

using Place = std::array<double, 3>;

template <int dim>
Place vertex(const MeshData<dim>& mesh, const unsigned int index) {
  Place place{};
  std::copy(mesh.vertices[index].begin(), mesh.vertices[index].end(), place.begin());
  return place;
}

Place difference(const Place& one, const Place& other) {
  return {one[0] - other[0], one[1] - other[1], one[2] - other[2]};
}

double length(const Place& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

Place cross(const Place& u, const Place& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A face's corners one after the other.
template <int dim>
std::vector<Place> corners(const MeshData<dim>& mesh, const Face<dim>& face) {
  std::vector<Place> result;
  for (const unsigned int index : face.vertices) result.push_back(vertex(mesh, index));
  return result;
}

/// Half the cross product of a quadrilateral's diagonals; of an edge its normal times its length.
template <int dim>
Place area_vector(const MeshData<dim>& mesh, const Face<dim>& face) {
  const std::vector<Place> c = corners(mesh, face);
  if (dim == 2) {
    const Place along = difference(c[1], c[0]);
    return {along[1], -along[0], 0.};
  }
  const Place twice = cross(difference(c[2], c[0]), difference(c[3], c[1]));
  return {twice[0] / 2., twice[1] / 2., twice[2] / 2.};
}

template <int dim>
Place middle(const MeshData<dim>& mesh, const Face<dim>& face) {
  Place sum{};
  const std::vector<Place> c = corners(mesh, face);
  for (const Place& corner : c)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += corner[i] / static_cast<double>(c.size());
  return sum;
}

template <int dim>
bool is_flat(const MeshData<dim>& mesh, const std::vector<const Face<dim>*>& faces) {
  constexpr double rounding = 1e-6;
  const Place first = area_vector(mesh, *faces.front());
  return std::all_of(faces.begin(), faces.end(), [&](const Face<dim>* face) {
    const Place own = area_vector(mesh, *face);
    return length(cross(first, own)) <= rounding * length(first) * length(own);
  });
}

template <int dim>
std::string shape_of(const MeshData<dim>& mesh, const std::vector<const Face<dim>*>& faces,
                     const std::string& unit, const double metres) {
  std::set<int> circles;
  for (const Face<dim>* face : faces) circles.insert(face->circle);
  if (circles.size() > 1) return "of several shapes";
  if (*circles.begin() < 0)
    return is_flat(mesh, faces) ? (dim == 2 ? "straight" : "plane") : "of flat pieces";
  const Circle& circle = mesh.circles[static_cast<std::size_t>(*circles.begin())];
  if (circle.ring_radius > 0.)
    return fmt::format("torus of radii {:.6g} and {:.6g} {}", circle.ring_radius / metres,
                       circle.radius / metres, unit);
  const char* const kind = dim == 2 ? "circle" : length(circle.axis) == 0. ? "sphere" : "cylinder";
  return fmt::format("{} of radius {:.6g} {}", kind, circle.radius / metres, unit);
}

/// Bodies that own faces, by the vertices of these.
template <int dim>
std::map<unsigned int, unsigned int> body_of_vertex(const MeshData<dim>& mesh) {
  std::map<unsigned int, unsigned int> bodies;
  for (const Cell<dim>& cell : mesh.cells)
    for (const unsigned int index : cell.vertices) bodies[index] = cell.body;
  return bodies;
}

template <int dim>
ListedSurface listed(const MeshData<dim>& mesh, const std::vector<const Face<dim>*>& faces) {
  ListedSurface result{};
  Place centre{};
  for (const Face<dim>* face : faces) {
    const double size = length(area_vector(mesh, *face));
    const Place at = middle(mesh, *face);
    for (std::size_t i = 0; i < 3; ++i) centre[i] += size * at[i];
    result.size += size;
    result.faces.push_back(corners(mesh, *face));
  }
  for (double& coordinate : centre) coordinate /= result.size;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face<dim>* face : faces) {
    const Place at = middle(mesh, *face);
    const double distance = length(difference(at, centre));
    if (distance < nearest) {
      nearest = distance;
      result.place = at;
    }
  }
  return result;
}

}  // namespace

template <int dim>
std::vector<ListedSurface> list_surfaces(const MeshData<dim>& mesh, const std::string& unit,
                                         const double metres) {
  const std::map<unsigned int, unsigned int> bodies = body_of_vertex(mesh);
  std::map<std::pair<unsigned int, unsigned int>, std::vector<const Face<dim>*>> faces_of;
  for (const Face<dim>& face : mesh.faces)
    if (face.surface != 0)
      faces_of[{bodies.at(face.vertices.front()), face.surface}].push_back(&face);
  std::vector<ListedSurface> result;
  for (const auto& [key, faces] : faces_of) {
    ListedSurface surface = listed(mesh, faces);
    surface.body = mesh.bodies[key.first];
    surface.name = mesh.surfaces[key.second];
    surface.shape = shape_of(mesh, faces, unit, metres);
    result.push_back(std::move(surface));
  }
  return result;
}

template std::vector<ListedSurface> list_surfaces(const MeshData<2>&, const std::string&, double);
template std::vector<ListedSurface> list_surfaces(const MeshData<3>&, const std::string&, double);

}  // namespace geneva::mesh
