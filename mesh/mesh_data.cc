#include "mesh/mesh_data.h"

#include <fmt/format.h>
#include <stdexcept>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/errors.h"
#include "mesh/mesh_quality.h"

namespace geneva::mesh {

namespace {

/// Below this scaled Jacobian (1: a rectangle, 0: two sides in one line) results are worthless.
constexpr double minimum_scaled_jacobian = 0.02;

/// A vertex may stand off the circle that its face belongs to by this fraction of the radius.
constexpr double circle_tolerance = 1e-6;

constexpr unsigned int no_body = static_cast<unsigned int>(-1);

/// How a face is called.
template <int dim>
constexpr const char* face_word = dim == 2 ? "edge" : "face";

template <typename... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> message, const Values&... values) {
  throw base::InputError("mesh: " + fmt::format(message, values...));
}

/// "(x, y) m" or "(x, y, z) m".
template <std::size_t dim>
std::string shown(const std::array<double, dim>& place) {
  return fmt::format("({:.6g}) m", fmt::join(place, ", "));
}

template <int dim>
void check_vertices(const MeshData<dim>& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!std::all_of(mesh.vertices[i].begin(), mesh.vertices[i].end(),
                     [](const double coordinate) { return std::isfinite(coordinate); }))
      refuse("vertex {} stands at {}: coordinates must be finite", i, shown(mesh.vertices[i]));
}

template <int dim>
void check_surfaces(const MeshData<dim>& mesh) {
  if (mesh.surfaces.empty() || !mesh.surfaces.front().empty())
    refuse("the first surface must be \"\", which holds the {}s without a name", face_word<dim>);
}

template <int dim>
void check_indices(const MeshData<dim>& mesh) {
  const auto beyond = [&](unsigned int vertex) { return vertex >= mesh.vertices.size(); };
  const auto any_beyond = [&](const auto& vertices) {
    return std::any_of(vertices.begin(), vertices.end(), beyond);
  };
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const Cell<dim>& cell = mesh.cells[i];
    if (any_beyond(cell.vertices))
      refuse("cell {} refers to a vertex beyond the {} that exist", i, mesh.vertices.size());
    if (cell.body >= mesh.bodies.size())
      refuse("cell {} belongs to body {} of {}", i, cell.body, mesh.bodies.size());
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face<dim>& face = mesh.faces[i];
    const char* const word = face_word<dim>;
    if (any_beyond(face.vertices))
      refuse("{} {} refers to a vertex beyond the {} that exist", word, i, mesh.vertices.size());
    if (face.surface >= mesh.surfaces.size())
      refuse("{} {} belongs to surface {} of {}", word, i, face.surface, mesh.surfaces.size());
    if (face.circle < -1 || face.circle >= static_cast<int>(mesh.circles.size()))
      refuse("{} {} belongs to circle {} of {}", word, i, face.circle, mesh.circles.size());
  }
}

template <int dim>
void check_cells(const MeshData<dim>& mesh) {
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const double quality = scaled_jacobian(mesh, mesh.cells[i]);
    if (quality > minimum_scaled_jacobian) continue;
    refuse(
        "cell {} of body \"{}\" near {} is degenerate or turned over (scaled Jacobian {:.3g}, more "
        "than {} is needed): use smaller cells there, or move the points that pinch it",
        i, mesh.bodies[mesh.cells[i].body], shown(mesh.vertices[mesh.cells[i].vertices[0]]),
        quality, minimum_scaled_jacobian);
  }
}

/// Where a face is, in words.
template <int dim>
std::string between(const MeshData<dim>& mesh,
                    const std::array<unsigned int, 1U << (dim - 1)>& vertices) {
  const auto& end = mesh.vertices[vertices[vertices.size() / 2]];
  return fmt::format("from {} to {}", shown(mesh.vertices[vertices[0]]), shown(end));
}

/// Whether two sides with the same vertices go round them the same way.
template <std::size_t n>
bool go_the_same_way(const std::array<unsigned int, n>& one,
                     const std::array<unsigned int, n>& other) {
  if constexpr (n == 2) return one == other;
  const auto after_first = std::find(other.begin(), other.end(), one[0]) - other.begin() + 1;
  return other[static_cast<std::size_t>(after_first) % n] == one[1];
}

/// Refuses cells that lie on the same side of the side that they share.
template <int dim>
void check_folds(const MeshData<dim>& mesh) {
  using Side = std::array<unsigned int, 1U << (dim - 1)>;
  std::map<Side, Side> first;
  for (const Cell<dim>& cell : mesh.cells)
    for (const Side& side : sides(cell)) {
      Side key = side;
      std::sort(key.begin(), key.end());
      const auto [other, is_new] = first.emplace(key, side);
      if (!is_new && go_the_same_way(side, other->second))
        refuse("the two cells at the {} {} lie on the same side of it: the mesh is folded there",
               face_word<dim>, between(mesh, side));
    }
}

template <int dim>
void check_boundary(const MeshData<dim>& mesh) {
  using Side = std::array<unsigned int, 1U << (dim - 1)>;
  struct Count {
    Side side;
    int missing;  // times that a side of a cell has still to be accounted for
  };
  const auto key = [](Side side) {
    std::sort(side.begin(), side.end());
    return side;
  };
  std::map<Side, Count> counts;
  for (const Cell<dim>& cell : mesh.cells)
    for (const Side& side : sides(cell))
      ++counts.emplace(key(side), Count{side, 0}).first->second.missing;
  for (const auto& [sorted, count] : counts)
    if (count.missing > 2)
      refuse("{} cells meet at the side {}: at most two may", count.missing,
             between(mesh, count.side));
  const char* const word = face_word<dim>;
  for (const Face<dim>& face : mesh.faces) {
    const auto found = counts.find(key(face.vertices));
    if (found == counts.end())
      refuse("the boundary {} {} is no side of a cell", word, between(mesh, face.vertices));
    if (found->second.missing != 1)
      refuse("the {} {} is listed twice or lies inside a body", word, between(mesh, face.vertices));
    found->second.missing = 0;
  }
  for (const auto& [sorted, count] : counts)
    if (count.missing == 1)
      refuse("the boundary {} {} is not listed", word, between(mesh, count.side));
}

/// Refuses faces of the boundary that have three vertices in common: cells that should share a face
/// there overlap, or leave a slit between them, which the refinement does not survive.
void check_slits(const MeshData<3>& mesh) {
  using Three = std::array<unsigned int, 3>;
  std::map<Three, const Face<3>*> seen;
  for (const Face<3>& face : mesh.faces)
    for (std::size_t left_out = 0; left_out < face.vertices.size(); ++left_out) {
      Three three{};
      std::copy_if(face.vertices.begin(), face.vertices.end(), three.begin(),
                   [&](const unsigned int& v) { return &v != &face.vertices[left_out]; });
      std::sort(three.begin(), three.end());
      const auto [other, is_new] = seen.emplace(three, &face);
      if (!is_new)
        refuse(
            "the boundary faces {} and {} have three vertices in common: the cells behind them "
            "overlap or leave a slit; let them share the face",
            between(mesh, other->second->vertices), between(mesh, face.vertices));
    }
}
void check_slits(const MeshData<2>& /*mesh*/) {}  // two edges have one vertex in common at most

/// Which corners of cells hang together (union-find).
class HangingTogether {
 public:
  explicit HangingTogether(const std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::size_t root(std::size_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(const std::size_t one, const std::size_t other) { parent_[root(one)] = root(other); }

 private:
  std::vector<std::size_t> parent_;
};

/// Refuses vertices whose cells do not hang together by common sides: a body would be hinged there,
/// or its cells overlap, which the refinement does not survive.
template <int dim>
void check_hinges(const MeshData<dim>& mesh) {
  using Side = std::array<unsigned int, 1U << (dim - 1)>;
  constexpr std::size_t n_corners = 1U << dim;
  HangingTogether corners(n_corners * mesh.cells.size());
  const auto corner = [&](const std::size_t cell, const unsigned int vertex) {
    const auto& vertices = mesh.cells[cell].vertices;
    return n_corners * cell +
           static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), vertex) -
                                    vertices.begin());
  };
  std::map<Side, std::size_t> first_cell;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (Side side : sides(mesh.cells[cell])) {
      std::sort(side.begin(), side.end());
      const auto [other, is_new] = first_cell.emplace(side, cell);
      if (is_new) continue;
      for (const unsigned int vertex : side)
        corners.join(corner(cell, vertex), corner(other->second, vertex));
    }
  std::vector<std::optional<std::size_t>> root_at(mesh.vertices.size());
  for (std::size_t i = 0; i < n_corners * mesh.cells.size(); ++i) {
    const unsigned int vertex = mesh.cells[i / n_corners].vertices[i % n_corners];
    const std::size_t root = corners.root(i);
    if (root_at[vertex].value_or(root) != root)
      refuse(
          "the cells around the vertex at {} have no common {} there: they overlap, or the body "
          "is hinged there; let them share {}s, or give them vertices of their own",
          shown(mesh.vertices[vertex]), face_word<dim>, face_word<dim>);
    root_at[vertex] = root;
  }
}

template <int dim>
void check_circles(const MeshData<dim>& mesh) {
  for (const Face<dim>& face : mesh.faces) {
    if (face.circle < 0) continue;
    const Circle& circle = mesh.circles[static_cast<std::size_t>(face.circle)];
    for (const unsigned int vertex : face.vertices) {
      const auto& place = mesh.vertices[vertex];
      std::array<double, 3> point{};
      std::copy(place.begin(), place.end(), point.begin());
      const auto [x, y, z] = radial(circle, point);
      const double off = std::hypot(x, y, z) - circle.radius;
      if (!(std::abs(off) <= circle_tolerance * circle.radius))
        refuse("the vertex at {} stands {:.3g} m off the circle of its {}", shown(place), off,
               face_word<dim>);
    }
  }
}

}  // namespace

std::array<double, 3> radial(const Circle& circle, const std::array<double, 3>& point) {
  std::array<double, 3> arm{};
  double along = 0.;
  for (std::size_t i = 0; i < 3; ++i) {
    arm[i] = point[i] - circle.centre[i];
    along += arm[i] * circle.axis[i];
  }
  for (std::size_t i = 0; i < 3; ++i) arm[i] -= along * circle.axis[i];
  if (circle.ring_radius == 0.) return arm;
  const double off_axis = std::hypot(arm[0], arm[1], arm[2]);
  if (off_axis == 0.) {  // any direction across the axis is as near
    const std::size_t across = std::abs(circle.axis[0]) < 0.9 ? 0 : 1;
    arm = {-circle.axis[across] * circle.axis[0], -circle.axis[across] * circle.axis[1],
           -circle.axis[across] * circle.axis[2]};
    arm[across] += 1.;
    const double length = std::hypot(arm[0], arm[1], arm[2]);
    for (std::size_t i = 0; i < 3; ++i)
      arm[i] = along * circle.axis[i] - circle.ring_radius / length * arm[i];
    return arm;
  }
  for (std::size_t i = 0; i < 3; ++i)
    arm[i] += along * circle.axis[i] - circle.ring_radius / off_axis * arm[i];
  return arm;
}

std::array<std::array<double, 3>, 3> curvature(const Circle& circle,
                                               const std::array<double, 3>& point,
                                               const std::array<double, 3>& normal) {
  const bool is_torus = circle.ring_radius > 0.;
  const std::array<double, 3> arm = radial({circle.centre, circle.radius, circle.axis}, point);
  const double off_axis = std::hypot(arm[0], arm[1], arm[2]);
  // cos(a) of the point's tube from the distances of its middle and of the point from the axis
  const double around_axis =
      is_torus ? (off_axis - circle.ring_radius) / (circle.radius * off_axis) : 0.;
  std::array<std::array<double, 3>, 3> tensor{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double across_axis = (i == k ? 1. : 0.) - circle.axis[i] * circle.axis[k];
      const double tangent = is_torus ? across_axis - arm[i] * arm[k] / (off_axis * off_axis) : 0.;
      const double of_tube =
          (is_torus ? (i == k ? 1. : 0.) - tangent : across_axis) - normal[i] * normal[k];
      tensor[i][k] = of_tube / circle.radius + around_axis * tangent;
    }
  return tensor;
}

template <int dim>
std::vector<std::array<unsigned int, 1U << (dim - 1)>> sides(const Cell<dim>& cell) {
  const auto& v = cell.vertices;
  std::vector<std::array<unsigned int, 1U << (dim - 1)>> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if constexpr (dim == 2)
      result.push_back({v[i], v[next]});
    else
      result.push_back({v[i], v[next], v[next + 4], v[i + 4]});
  }
  if constexpr (dim == 3) {
    result.push_back({v[0], v[3], v[2], v[1]});
    result.push_back({v[4], v[5], v[6], v[7]});
  }
  return result;
}

template <int dim>
void check_bodies(const MeshData<dim>& mesh) {
  std::vector<unsigned int> body_of(mesh.vertices.size(), no_body);
  std::vector<bool> has_cells(mesh.bodies.size(), false);
  for (const Cell<dim>& cell : mesh.cells) {
    has_cells[cell.body] = true;
    for (const unsigned int vertex : cell.vertices) {
      if (body_of[vertex] != no_body && body_of[vertex] != cell.body)
        refuse(
            "bodies \"{}\" and \"{}\" share the vertex at {} and would be welded there: give each "
            "body its own points, curves and surfaces, also where they touch",
            mesh.bodies[body_of[vertex]], mesh.bodies[cell.body], shown(mesh.vertices[vertex]));
      body_of[vertex] = cell.body;
    }
  }
  for (std::size_t i = 0; i < mesh.bodies.size(); ++i)
    if (!has_cells[i]) refuse("body \"{}\" has no cells", mesh.bodies[i]);
  for (std::size_t i = 0; i < body_of.size(); ++i)
    if (body_of[i] == no_body)
      refuse("vertex {} at {} belongs to no cell: remove it", i, shown(mesh.vertices[i]));
}

unsigned int index_of(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::out_of_range("no surface or body is named '" + name + "'");
  return static_cast<unsigned int>(found - names.begin());
}

template <int dim>
std::set<unsigned int> bodies_of(const MeshData<dim>& mesh, const unsigned int surface) {
  std::set<unsigned int> vertices;
  for (const Face<dim>& face : mesh.faces)
    if (face.surface == surface) vertices.insert(face.vertices.begin(), face.vertices.end());
  std::set<unsigned int> bodies;
  for (const Cell<dim>& cell : mesh.cells)
    for (const unsigned int vertex : cell.vertices)
      if (vertices.count(vertex) > 0) bodies.insert(cell.body);
  return bodies;
}

template <int dim>
void check(const MeshData<dim>& mesh) {
  check_surfaces(mesh);
  check_vertices(mesh);
  check_indices(mesh);
  check_bodies(mesh);
  check_cells(mesh);
  check_boundary(mesh);
  check_slits(mesh);
  check_folds(mesh);
  check_hinges(mesh);
  check_circles(mesh);
}

template std::vector<std::array<unsigned int, 2>> sides(const Cell<2>&);
template std::vector<std::array<unsigned int, 4>> sides(const Cell<3>&);
template void check_bodies(const MeshData<2>&);
template void check_bodies(const MeshData<3>&);
template std::set<unsigned int> bodies_of(const MeshData<2>&, unsigned int);
template std::set<unsigned int> bodies_of(const MeshData<3>&, unsigned int);
template void check(const MeshData<2>&);
template void check(const MeshData<3>&);

}  // namespace geneva::mesh
