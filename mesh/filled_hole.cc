#include "mesh/filled_hole.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

/// The hole's vertices move to these shares of its radius: the corners of a square grid would
/// otherwise be flat.
constexpr double at_corners = 1.1;
constexpr double at_middle_of_sides = 0.85;

/// Where the grid's first corner is looked for: a little before the diagonal, so that rounding does
/// not decide between two vertices.
constexpr double pi = 3.14159265358979323846;
constexpr double first_corner = -0.75 * pi - 1e-6;

using Place = std::array<double, 2>;

/// The hole's vertices, counter-clockwise around its centre.
struct Hole {
  Place centre{};
  std::vector<unsigned int> vertices;
  unsigned int body = 0;
};

Hole hole_of(const MeshData<2>& mesh, const unsigned int surface) {
  Hole hole;
  for (const Face<2>& face : mesh.faces)
    if (face.surface == surface) hole.vertices.push_back(face.vertices[0]);
  if (hole.vertices.size() < 8 || hole.vertices.size() % 2 != 0)
    throw base::InputError(
        fmt::format("a hole of {} edges cannot be filled: an even number is wanted, eight or more",
                    hole.vertices.size()));
  for (const unsigned int vertex : hole.vertices)
    for (std::size_t i = 0; i < 2; ++i)
      hole.centre[i] += mesh.vertices[vertex][i] / static_cast<double>(hole.vertices.size());
  const auto angle = [&](const unsigned int vertex) {
    const double x = mesh.vertices[vertex][0] - hole.centre[0];
    const double y = mesh.vertices[vertex][1] - hole.centre[1];
    const double c = std::cos(first_corner + pi);
    const double s = std::sin(first_corner + pi);
    return std::atan2(c * y - s * x, c * x + s * y);
  };
  std::sort(hole.vertices.begin(), hole.vertices.end(),
            [&](const unsigned int a, const unsigned int b) { return angle(a) < angle(b); });
  hole.body = *bodies_of(mesh, surface).begin();
  return hole;
}

/// A grid of n x m cells in the hole, by the places (i, j) of its nodes.
class SquareGrid {
 public:
  SquareGrid(MeshData<2>& mesh, const Hole& hole)
      : mesh_(mesh),
        hole_(hole),
        n_(hole.vertices.size() / 4),
        m_(hole.vertices.size() / 2 - n_),
        nodes_((n_ + 1) * (m_ + 1)) {}

  void fill() {
    round_off_corners();
    for (std::size_t i = 0; i <= n_; ++i)
      for (std::size_t j = 0; j <= m_; ++j) node(i, j) = is_inner(i, j) ? added(i, j) : rim(i, j);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < m_; ++j)
        mesh_.cells.push_back(
            {{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}, hole_.body});
  }

 private:
  unsigned int& node(const std::size_t i, const std::size_t j) { return nodes_[i * (m_ + 1) + j]; }

  [[nodiscard]] bool is_inner(const std::size_t i, const std::size_t j) const {
    return i > 0 && i < n_ && j > 0 && j < m_;
  }

  /// The hole's vertex at a place on the grid's rim, which starts at (0, 0) towards (n, 0).
  [[nodiscard]] unsigned int rim(const std::size_t i, const std::size_t j) const {
    const std::size_t along = j == 0    ? i
                              : i == n_ ? n_ + j
                              : j == m_ ? 2 * n_ + m_ - i
                                        : 2 * (n_ + m_) - j;
    return hole_.vertices[along % hole_.vertices.size()];
  }

  /// Blended from the four sides (transfinite interpolation).
  unsigned int added(const std::size_t i, const std::size_t j) {
    const double a = static_cast<double>(i) / static_cast<double>(n_);
    const double b = static_cast<double>(j) / static_cast<double>(m_);
    Place place{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = [&](const std::size_t row, const std::size_t column) {
        return mesh_.vertices[rim(row, column)][k];
      };
      place[k] = (1. - a) * at(0, j) + a * at(n_, j) + (1. - b) * at(i, 0) + b * at(i, m_) -
                 (1. - a) * ((1. - b) * at(0, 0) + b * at(0, m_)) -
                 a * ((1. - b) * at(n_, 0) + b * at(n_, m_));
    }
    mesh_.vertices.push_back(place);
    return static_cast<unsigned int>(mesh_.vertices.size()) - 1;
  }

  void round_off_corners() {
    const auto move = [&](const std::size_t start, const std::size_t length) {
      for (std::size_t k = 0; k < length; ++k) {
        const double from_middle = 2. * static_cast<double>(k) / static_cast<double>(length) - 1.;
        const double share =
            at_middle_of_sides + (at_corners - at_middle_of_sides) * from_middle * from_middle;
        Place& place = mesh_.vertices[hole_.vertices[(start + k) % hole_.vertices.size()]];
        for (std::size_t c = 0; c < 2; ++c)
          place[c] = hole_.centre[c] + share * (place[c] - hole_.centre[c]);
      }
    };
    move(0, n_);
    move(n_, m_);
    move(n_ + m_, n_);
    move(2 * n_ + m_, m_);
  }

  MeshData<2>& mesh_;
  const Hole& hole_;
  std::size_t n_;
  std::size_t m_;
  std::vector<unsigned int> nodes_;
};

}  // namespace

MeshData<2> with_filled_hole(const MeshData<2>& mesh, const std::string& surface) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), surface);
  const auto id = static_cast<unsigned int>(found - mesh.surfaces.begin());
  if (found == mesh.surfaces.end())
    throw base::InputError(fmt::format("there is no surface '{}' to fill", surface));
  const Hole hole = hole_of(mesh, id);
  MeshData<2> filled = mesh;
  filled.faces.erase(std::remove_if(filled.faces.begin(), filled.faces.end(),
                                    [&](const Face<2>& face) { return face.surface == id; }),
                     filled.faces.end());
  SquareGrid(filled, hole).fill();
  check(filled);
  return filled;
}

}  // namespace geneva::mesh
