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
  constexpr double round_off = 1e-6;
  for (const CoarseFace& one : faces)
    for (const CoarseFace& other : faces)
      if (!is_smooth(one, other) &&
          one.normal.dot(other.inwards) > round_off * other.inwards.norm())
        return true;
  return false;
}

template <int dim>
bool is_held(const BoundaryTractions<dim>& tractions, const CoarseFace& face) {
  return tractions.surfaces[face.surface].kind == TractionKind::held;
}

/// A face that is neither held nor goes on beyond a plane of symmetry.
template <int dim>
bool is_free(const BoundaryTractions<dim>& tractions, const CoarseFace& face) {
  const TractionKind kind = tractions.surfaces[face.surface].kind;
  return kind == TractionKind::given || kind == TractionKind::contact;
}

/// Where a face that is held along its normal alone goes on as one that is not: a plane of symmetry
/// there would have a crack beside it.
template <int dim>
const CoarseFace* end_of_normal_support(const std::vector<CoarseFace>& faces,
                                        const BoundaryTractions<dim>& tractions) {
  for (const CoarseFace& one : faces)
    for (const CoarseFace& other : faces)
      if (tractions.surfaces[one.surface].kind == TractionKind::mirrored &&
          is_free(tractions, other) && is_smooth(one, other))
        return &one;
  return nullptr;
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
  if (const CoarseFace* const mirrored = end_of_normal_support(faces, tractions))
    return std::make_pair(Singularity::end_of_support, mirrored->surface);
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

namespace {

template <int dim>
dealii::Point<dim> point_of(const Components<dim>& place) {
  dealii::Point<dim> result;
  for (unsigned int i = 0; i < dim; ++i) result[i] = place[i];
  return result;
}

/// A vertex of a boundary face of the coarse mesh, and how far its faces reach.
struct Corner {
  unsigned int vertex;
  unsigned int surface;
  double reach;  ///< [m]
};

/// The one nearest to a place.
template <int dim>
std::optional<std::pair<Corner, double>> nearest_corner(const mesh::MeshData<dim>& mesh,
                                                        const dealii::Point<dim>& place) {
  std::optional<std::pair<Corner, double>> nearest;
  for (const mesh::Face<dim>& face : mesh.faces)
    for (const unsigned int vertex : face.vertices) {
      const dealii::Point<dim> corner = point_of<dim>(mesh.vertices[vertex]);
      double reach = 0.;
      for (const unsigned int other : face.vertices)
        reach = std::max(reach, corner.distance(point_of<dim>(mesh.vertices[other])));
      const double distance = corner.distance(place);
      if (!nearest || distance < nearest->second)
        nearest = {{vertex, face.surface, reach}, distance};
      else if (vertex == nearest->first.vertex)
        nearest->first.reach = std::min(nearest->first.reach, reach);
    }
  return nearest;
}

/// Whether a stress grows over three refinements as one without bound does.
bool grows(const std::vector<StressRecord>& course, const std::size_t last) {
  constexpr double least = 0.1;
  constexpr double share_of_first = 0.7;
  std::array<double, 3> growth{};
  for (std::size_t i = 0; i < 3; ++i) {
    const StressRecord& now = course[last - 2 + i];
    const StressRecord& before = course[last - 3 + i];
    if (before.value == 0. || now.is_round) return false;
    growth[i] = now.value / before.value - 1.;
  }
  return *std::min_element(growth.begin(), growth.end()) >= least &&
         growth[2] >= share_of_first * growth[0];
}

/// Adds the corner at which a stress grows, if it does.
template <int dim>
void add_grown(const mesh::MeshData<dim>& mesh, const std::vector<StressRecord>& course,
               std::vector<SingularPlace<dim>>& places) {
  constexpr double near = 0.1;
  for (std::size_t last = 3; last < course.size(); ++last) {
    if (!grows(course, last)) continue;
    dealii::Point<dim> place;
    for (unsigned int i = 0; i < dim; ++i) place[i] = course[last].place[i];
    const auto corner = nearest_corner(mesh, place);
    if (!corner || corner->second > near * corner->first.reach || is_beside(places, place))
      continue;
    const Components<dim>& at = mesh.vertices[corner->first.vertex];
    places.push_back({at, at, corner->first.reach, Singularity::growth, corner->first.surface});
  }
}

}  // namespace

template <int dim>
std::vector<SingularPlace<dim>> grown_places(const mesh::MeshData<dim>& mesh,
                                             const std::vector<LevelRecord>& history) {
  std::vector<SingularPlace<dim>> places;
  if (history.empty()) return places;
  for (std::size_t body = 0; body < history.front().strength.size(); ++body)
    for (StressRecord StrengthRecord::*const measure :
         {&StrengthRecord::von_mises, &StrengthRecord::tensile}) {
      std::vector<StressRecord> course;
      for (const LevelRecord& level : history) course.push_back(level.strength[body].*measure);
      add_grown(mesh, course, places);
    }
  return places;
}

template <int dim>
bool is_beside(const std::vector<SingularPlace<dim>>& singular, const dealii::Point<dim>& place) {
  return std::any_of(singular.begin(), singular.end(), [&](const SingularPlace<dim>& other) {
    const dealii::Point<dim> begin = point_of<dim>(other.begin);
    const dealii::Tensor<1, dim> along = point_of<dim>(other.end) - begin;
    const double square = along.norm_square();
    const double at = square > 0. ? std::clamp(along * (place - begin) / square, 0., 1.) : 0.;
    return (place - (begin + at * along)).norm() < other.radius;
  });
}

template <int dim>
bool is_clear(const std::vector<SingularPlace<dim>>& singular, const Components<dim>& place) {
  constexpr double near = 1.5;
  std::vector<SingularPlace<dim>> surroundings = singular;
  for (SingularPlace<dim>& other : surroundings) other.radius *= near;
  return !is_beside(surroundings, point_of<dim>(place));
}

template bool is_clear(const std::vector<SingularPlace<2>>&, const Components<2>&);
template bool is_clear(const std::vector<SingularPlace<3>>&, const Components<3>&);
template bool is_beside(const std::vector<SingularPlace<2>>&, const dealii::Point<2>&);
template bool is_beside(const std::vector<SingularPlace<3>>&, const dealii::Point<3>&);
template std::vector<SingularPlace<2>> grown_places(const mesh::MeshData<2>&,
                                                    const std::vector<LevelRecord>&);
template std::vector<SingularPlace<3>> grown_places(const mesh::MeshData<3>&,
                                                    const std::vector<LevelRecord>&);
template std::vector<SingularPlace<2>> singular_places(const mesh::MeshData<2>&,
                                                       const BoundaryTractions<2>&);
template std::vector<SingularPlace<3>> singular_places(const mesh::MeshData<3>&,
                                                       const BoundaryTractions<3>&);

}  // namespace geneva::fem
