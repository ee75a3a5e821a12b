#include "mesh/compact_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace geneva::mesh {

namespace {

/// Cells with this ratio of their sides are left as they are.
constexpr double compact = 1.5;
/// No edge is cut into more pieces, however thin the cells are: into many only as long as the whole
/// mesh keeps few cells.
constexpr unsigned int many_pieces = 64;
constexpr unsigned int few_pieces = 8;
constexpr std::size_t few_cells = 2000;

using Point = std::array<double, 2>;
using Edge = std::pair<unsigned int, unsigned int>;  ///< vertices, the smaller first

Edge edge_of(const unsigned int from, const unsigned int to) {
  return {std::min(from, to), std::max(from, to)};
}

Point between(const Point& from, const Point& to, const double share) {
  return {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
}

/// The edges of a mesh in strips: edges that lie opposite to each other across a cell.
class Strips {
 public:
  explicit Strips(const MeshData<2>& mesh) {
    for (const Cell<2>& cell : mesh.cells)
      for (std::size_t i = 0; i < 4; ++i)
        numbers_.emplace(edge_of(cell.vertices[i], cell.vertices[(i + 1) % 4]), numbers_.size());
    parents_.resize(numbers_.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
    for (const Cell<2>& cell : mesh.cells) {
      const auto& v = cell.vertices;
      join(edge_of(v[0], v[1]), edge_of(v[2], v[3]));
      join(edge_of(v[1], v[2]), edge_of(v[3], v[0]));
    }
  }

  [[nodiscard]] std::size_t strip(const Edge& edge) const {
    std::size_t root = numbers_.at(edge);
    while (parents_[root] != root) root = parents_[root];
    return root;
  }

 private:
  void join(const Edge& one, const Edge& other) { parents_[strip(one)] = strip(other); }

  std::map<Edge, std::size_t> numbers_;
  std::vector<std::size_t> parents_;
};

double length(const MeshData<2>& mesh, const unsigned int from, const unsigned int to) {
  return std::hypot(mesh.vertices[to][0] - mesh.vertices[from][0],
                    mesh.vertices[to][1] - mesh.vertices[from][1]);
}

/// Number of pieces for the strips that are cut.
using Pieces = std::map<std::size_t, unsigned int>;

void cut(Pieces& pieces, const std::size_t strip, const double ratio,
         const unsigned int most_pieces) {
  if (ratio <= compact) return;
  const auto wanted = static_cast<unsigned int>(std::lround(std::min<double>(ratio, most_pieces)));
  pieces[strip] = std::max(pieces[strip], wanted);
}

Pieces wanted_pieces(const MeshData<2>& mesh, const Strips& strips,
                     const std::vector<std::string>& surfaces, const unsigned int most_pieces) {
  std::set<Edge> along;
  for (const Face<2>& face : mesh.faces)
    if (std::find(surfaces.begin(), surfaces.end(), mesh.surfaces[face.surface]) != surfaces.end())
      along.insert(edge_of(face.vertices[0], face.vertices[1]));
  Pieces pieces;
  for (const Cell<2>& cell : mesh.cells)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto vertex = [&](const std::size_t k) { return cell.vertices[(i + k) % 4]; };
      if (along.count(edge_of(vertex(0), vertex(1))) == 0) continue;
      const double depth =
          0.5 * (length(mesh, vertex(1), vertex(2)) + length(mesh, vertex(3), vertex(0)));
      const double ratio = length(mesh, vertex(0), vertex(1)) / depth;
      cut(pieces, strips.strip(edge_of(vertex(0), vertex(1))), ratio, most_pieces);
      cut(pieces, strips.strip(edge_of(vertex(1), vertex(2))), 1. / ratio, most_pieces);
    }
  return pieces;
}

/// Of the mesh that is cut.
std::size_t number_of_cells(const MeshData<2>& mesh, const Strips& strips, const Pieces& pieces) {
  const auto across = [&](const unsigned int from, const unsigned int to) {
    const auto found = pieces.find(strips.strip(edge_of(from, to)));
    return found == pieces.end() ? std::size_t{1} : std::size_t{found->second};
  };
  std::size_t number = 0;
  for (const Cell<2>& cell : mesh.cells)
    number +=
        across(cell.vertices[0], cell.vertices[1]) * across(cell.vertices[1], cell.vertices[2]);
  return number;
}

/// The point that divides an arc of a circle in the ratio of its angles.
Point on_arc(const Circle& circle, const Point& from, const Point& to, const double share) {
  const auto arm = [&](const Point& point) {
    return Point{point[0] - circle.centre[0], point[1] - circle.centre[1]};
  };
  const Point a = arm(from);
  const Point b = arm(to);
  const double angle = share * std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  const double scale = circle.radius / std::hypot(a[0], a[1]);
  return {circle.centre[0] + scale * (std::cos(angle) * a[0] - std::sin(angle) * a[1]),
          circle.centre[1] + scale * (std::sin(angle) * a[0] + std::cos(angle) * a[1])};
}

/// The mesh with cut edges under construction.
class CutMesh {
 public:
  CutMesh(const MeshData<2>& mesh, const Strips& strips, const Pieces& pieces)
      : coarse_(mesh), strips_(strips), pieces_(pieces), fine_(mesh) {
    fine_.cells.clear();
    fine_.faces.clear();
    for (const Face<2>& face : mesh.faces)
      if (face.circle >= 0)
        circles_[edge_of(face.vertices[0], face.vertices[1])] =
            mesh.circles[static_cast<std::size_t>(face.circle)];
  }

  MeshData<2> made() && {
    for (const Cell<2>& cell : coarse_.cells) add(cell);
    for (const Face<2>& face : coarse_.faces) {
      const auto points = points_along(face.vertices[0], face.vertices[1]);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        fine_.faces.push_back({{points[i], points[i + 1]}, face.surface, face.circle});
    }
    return std::move(fine_);
  }

 private:
  unsigned int add(const Point& point) {
    fine_.vertices.push_back(point);
    return static_cast<unsigned int>(fine_.vertices.size() - 1);
  }

  /// Vertices of the fine mesh on an edge of the coarse one, from its one end to the other.
  std::vector<unsigned int> points_along(const unsigned int from, const unsigned int to) {
    const Edge edge = edge_of(from, to);
    std::vector<unsigned int>& points = points_[edge];
    if (points.empty()) {
      const auto found = pieces_.find(strips_.strip(edge));
      const unsigned int n = found == pieces_.end() ? 1 : found->second;
      const auto circle = circles_.find(edge);
      const Point& begin = coarse_.vertices[edge.first];
      const Point& end = coarse_.vertices[edge.second];
      points.push_back(edge.first);
      for (unsigned int i = 1; i < n; ++i) {
        const double share = static_cast<double>(i) / n;
        points.push_back(add(circle == circles_.end() ? between(begin, end, share)
                                                      : on_arc(circle->second, begin, end, share)));
      }
      points.push_back(edge.second);
    }
    std::vector<unsigned int> result = points;
    if (from != edge.first) std::reverse(result.begin(), result.end());
    return result;
  }

  /// A point inside a cell between those on its four edges (Coons's patch).
  Point inside(const std::array<Point, 4>& on_edges, const std::array<Point, 4>& corners,
               const double s, const double t) const {
    Point point{};
    for (std::size_t i = 0; i < 2; ++i)
      point[i] = (1. - t) * on_edges[0][i] + s * on_edges[1][i] + t * on_edges[2][i] +
                 (1. - s) * on_edges[3][i] -
                 ((1. - s) * (1. - t) * corners[0][i] + s * (1. - t) * corners[1][i] +
                  s * t * corners[2][i] + (1. - s) * t * corners[3][i]);
    return point;
  }

  void add(const Cell<2>& cell) {
    const auto& v = cell.vertices;
    const auto bottom = points_along(v[0], v[1]);
    const auto right = points_along(v[1], v[2]);
    const auto top = points_along(v[3], v[2]);
    const auto left = points_along(v[0], v[3]);
    const std::array<Point, 4> corners{coarse_.vertices[v[0]], coarse_.vertices[v[1]],
                                       coarse_.vertices[v[2]], coarse_.vertices[v[3]]};
    std::vector<std::vector<unsigned int>> rows{bottom};
    for (std::size_t j = 1; j + 1 < left.size(); ++j) {
      const double t = static_cast<double>(j) / static_cast<double>(left.size() - 1);
      std::vector<unsigned int> row{left[j]};
      for (std::size_t i = 1; i + 1 < bottom.size(); ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(bottom.size() - 1);
        const auto at = [&](const unsigned int vertex) { return fine_.vertices[vertex]; };
        row.push_back(
            add(inside({at(bottom[i]), at(right[j]), at(top[i]), at(left[j])}, corners, s, t)));
      }
      row.push_back(right[j]);
      rows.push_back(row);
    }
    rows.push_back(top);
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
      for (std::size_t i = 0; i + 1 < bottom.size(); ++i)
        fine_.cells.push_back(
            {{rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]}, cell.body});
  }

  const MeshData<2>& coarse_;
  const Strips& strips_;
  const Pieces& pieces_;
  MeshData<2> fine_;
  std::map<Edge, Circle> circles_;
  std::map<Edge, std::vector<unsigned int>> points_;
};

}  // namespace

MeshData<2> with_compact_cells(const MeshData<2>& mesh, const std::vector<std::string>& surfaces) {
  const Strips strips(mesh);
  Pieces pieces = wanted_pieces(mesh, strips, surfaces, many_pieces);
  if (number_of_cells(mesh, strips, pieces) > few_cells)
    pieces = wanted_pieces(mesh, strips, surfaces, few_pieces);
  if (pieces.empty()) return mesh;
  MeshData<2> result = CutMesh(mesh, strips, pieces).made();
  check(result);
  return result;
}

}  // namespace geneva::mesh
