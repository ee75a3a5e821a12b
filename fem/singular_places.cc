#include "fem/singular_places.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mesh/flat_faces.h"

namespace geneva::fem {

namespace {

/// A boundary face of the coarse mesh, seen from a ridge of its: one of its vertices in the plane,
/// in 3-D one of its edges.
struct CoarseFace {
  unsigned int surface;
  int circle;
  Eigen::Vector3d normal;   ///< outward unit vector, as if the face were flat
  Eigen::Vector3d inwards;  ///< from the ridge's middle to the face's [m]
};

/// In ascending order.
template <int dim>
using Ridge = std::array<unsigned int, static_cast<std::size_t>(dim - 1)>;

std::vector<Ridge<2>> ridges(const mesh::Face<2>& face) {
  return {{face.vertices[0]}, {face.vertices[1]}};
}

std::vector<Ridge<3>> ridges(const mesh::Face<3>& face) {
  std::vector<Ridge<3>> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [low, high] = std::minmax(face.vertices[i], face.vertices[(i + 1) % 4]);
    result.push_back({low, high});
  }
  return result;
}

template <typename Vertices>
std::set<unsigned int> as_set(const Vertices& vertices) {
  return {vertices.begin(), vertices.end()};
}

template <int dim, typename Vertices>
Eigen::Vector3d middle(const mesh::MeshData<dim>& mesh, const Vertices& vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const unsigned int vertex : vertices) sum += mesh::place_of(mesh, vertex);
  return sum / static_cast<double>(vertices.size());
}

template <int dim>
std::map<Ridge<dim>, std::vector<CoarseFace>> faces_by_ridge(const mesh::MeshData<dim>& mesh) {
  std::map<std::set<unsigned int>, Eigen::Vector3d> inside;  // the middle of a side's cell
  for (const mesh::Cell<dim>& cell : mesh.cells)
    for (const auto& side : mesh::sides(cell)) inside[as_set(side)] = middle(mesh, cell.vertices);
  std::map<Ridge<dim>, std::vector<CoarseFace>> result;
  for (const mesh::Face<dim>& face : mesh.faces) {
    const Eigen::Vector3d centre = middle(mesh, face.vertices);
    Eigen::Vector3d normal = mesh::flat_normal(mesh, face);
    if (normal.dot(centre - inside.at(as_set(face.vertices))) < 0.) normal = -normal;
    for (const Ridge<dim>& ridge : ridges(face))
      result[ridge].push_back({face.surface, face.circle, normal, centre - middle(mesh, ridge)});
  }
  return result;
}

/// Faces of one circle are one surface however few they are; flat ones whose normals differ by less
/// than 26 degrees stand for a round one.
bool is_smooth(const CoarseFace& one, const CoarseFace& other) {
  constexpr double cosine = 0.9;
  return (one.circle >= 0 && one.circle == other.circle) || one.normal.dot(other.normal) > cosine;
}

bool is_re_entrant(const std::vector<CoarseFace>& faces) {
  constexpr double rounding = 1e-6;
  for (const CoarseFace& one : faces)
    for (const CoarseFace& other : faces)
      if (!is_smooth(one, other) && one.normal.dot(other.inwards) > rounding * other.inwards.norm())
        return true;
  return false;
}

template <int dim>
bool is_held(const BoundaryTractions<dim>& tractions, const CoarseFace& face) {
  return tractions.surfaces[face.surface].kind == TractionKind::unknown;
}

/// A face that is neither held nor goes on beyond a plane of symmetry.
template <int dim>
bool is_free(const BoundaryTractions<dim>& tractions, const CoarseFace& face) {
  const TractionKind kind = tractions.surfaces[face.surface].kind;
  return kind == TractionKind::given || kind == TractionKind::contact;
}

/// What makes the stress singular at a ridge, and the surface that it belongs to.
template <int dim>
std::optional<std::pair<Singularity, unsigned int>> singularity(
    const std::vector<CoarseFace>& faces, const BoundaryTractions<dim>& tractions) {
  const auto held = std::find_if(faces.begin(), faces.end(),
                                 [&](const auto& face) { return is_held(tractions, face); });
  const bool has_free = std::any_of(faces.begin(), faces.end(),
                                    [&](const auto& face) { return is_free(tractions, face); });
  if (held != faces.end() && has_free)
    return std::make_pair(Singularity::end_of_support, held->surface);
  if (is_re_entrant(faces))
    return std::make_pair(Singularity::re_entrant_corner, faces.front().surface);
  return std::nullopt;
}

}  // namespace

template <int dim>
std::vector<SingularPlace<dim>> singular_places(const mesh::MeshData<dim>& mesh,
                                                const BoundaryTractions<dim>& tractions) {
  std::vector<SingularPlace<dim>> places;
  for (const auto& [ridge, faces] : faces_by_ridge(mesh)) {
    const auto found = singularity(faces, tractions);
    if (!found) continue;
    // twice from the ridge to the middle: as far as the faces reach
    double radius = std::numeric_limits<double>::max();
    for (const CoarseFace& face : faces) radius = std::min(radius, 2. * face.inwards.norm());
    places.push_back({mesh.vertices[ridge.front()], mesh.vertices[ridge.back()], radius,
                      found->first, found->second});
  }
  return places;
}

template std::vector<SingularPlace<2>> singular_places(const mesh::MeshData<2>&,
                                                       const BoundaryTractions<2>&);
template std::vector<SingularPlace<3>> singular_places(const mesh::MeshData<3>&,
                                                       const BoundaryTractions<3>&);

}  // namespace geneva::fem
