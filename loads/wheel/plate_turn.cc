#include "loads/wheel/plate_turn.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/errors.h"
#include "loads/pi.h"

namespace geneva::loads {

namespace {

using Lines = std::vector<double>;
using ElementMatrix = Eigen::Matrix<double, 12, 12>;

constexpr double finest_cells = 1. / 6.;  // over the thickness
constexpr int finest_on_each_side = 3;
constexpr double growth = 1.35;

/// Lines from a place to an end, at first finest ones, then growing; the first is left out.
void append_lines(Lines& lines, const double place, const double end, const double finest) {
  const double sign = end > place ? 1. : -1.;
  const double total = std::abs(end - place);
  double step = finest;
  double sum = 0.;
  for (int i = 0; sum + 1.3 * step < total; ++i) {
    sum += step;
    lines.push_back(place + sign * sum);
    if (i >= finest_on_each_side) step *= growth;
  }
  lines.push_back(end);
}

/// Lines around a place between two ends, and where marks are; none closer than half of the finest.
Lines lines_around(const double place, const double lower, const double upper,
                   const std::vector<double>& marks, const double finest) {
  Lines lines{place};
  if (place - lower > finest / 2.) append_lines(lines, place, lower, finest);
  if (upper - place > finest / 2.) append_lines(lines, place, upper, finest);
  for (const double mark : marks) {
    const auto is_near = [&](const double line) { return std::abs(line - mark) < finest / 2.; };
    if (mark > lower && mark < upper && std::none_of(lines.begin(), lines.end(), is_near))
      lines.push_back(mark);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

/// The outline as polygons, for asking what lies inside.
class Inside {
 public:
  explicit Inside(const Outline& outline) {
    for (const Loop& loop : outline.loops)
      for (const Segment& segment : loop) append(segment);
  }

  /// By the number of edges above.
  [[nodiscard]] bool operator()(const Point at) const {
    bool is_inside = false;
    for (const auto& [from, to] : edges_)
      if ((from.x > at.x) != (to.x > at.x) &&
          from.y + (at.x - from.x) / (to.x - from.x) * (to.y - from.y) > at.y)
        is_inside = !is_inside;
    return is_inside;
  }

 private:
  void append(const Segment& segment) {
    constexpr int chords = 8;
    if (!segment.is_arc) {
      edges_.push_back({segment.start, segment.end});
      return;
    }
    const auto [cx, cy] = segment.centre;
    const double radius = std::hypot(segment.start.x - cx, segment.start.y - cy);
    const double from = std::atan2(segment.start.y - cy, segment.start.x - cx);
    double sweep = std::atan2(segment.end.y - cy, segment.end.x - cx) - from;
    if (segment.clockwise && sweep > 0.) sweep -= 2. * pi;
    if (!segment.clockwise && sweep < 0.) sweep += 2. * pi;
    Point last = segment.start;
    for (int i = 1; i <= chords; ++i) {
      const double angle = from + sweep * i / chords;
      const Point next = i == chords
                             ? segment.end
                             : Point{cx + radius * std::cos(angle), cy + radius * std::sin(angle)};
      edges_.push_back({last, next});
      last = next;
    }
  }

  std::vector<std::array<Point, 2>> edges_;
};

/// Part of a rectangle that lies inside.
double part_inside(const Inside& inside, const Point lower, const double width,
                   const double height) {
  constexpr int samples = 4;
  int found = 0;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j)
      if (inside({lower.x + (i + 0.5) / samples * width, lower.y + (j + 0.5) / samples * height}))
        ++found;
  return static_cast<double>(found) / (samples * samples);
}

/// Stiffness of a rectangle; dofs w, beta_x, beta_y of its corners (0,0), (1,0), (0,1), (1,1), with
/// the curvatures d beta and the shear strains grad w - beta.
class PlateElement {
 public:
  PlateElement(const double thickness, const Elastic& material) {
    const double nu = material.poissons_ratio;
    const double bending =
        material.youngs_modulus * std::pow(thickness, 3) / (12. * (1. - nu * nu));
    bending_ << bending, nu * bending, 0., nu * bending, bending, 0., 0., 0.,
        bending * (1. - nu) / 2.;
    shear_ = 5. / 6. * material.youngs_modulus / (2. * (1. + nu)) * thickness;
  }

  [[nodiscard]] ElementMatrix stiffness(const double width, const double height) const {
    const double gauss = 0.5 / std::sqrt(3.);
    ElementMatrix result = ElementMatrix::Zero();
    for (const double x : {0.5 - gauss, 0.5 + gauss})
      for (const double y : {0.5 - gauss, 0.5 + gauss}) {
        const auto strains = curvatures(x, y, width, height);
        result += width * height / 4. * strains.transpose() * bending_ * strains;
      }
    const auto strains = shear_strains(width, height);
    return result + width * height * shear_ * strains.transpose() * strains;
  }

 private:
  struct Shape {
    double value;
    double dx;
    double dy;
  };
  static Shape shape(const int corner, const double x, const double y, const double width,
                     const double height) {
    const bool right = corner % 2 == 1;
    const bool top = corner / 2 == 1;
    const double along = right ? x : 1. - x;
    const double across = top ? y : 1. - y;
    return {along * across, (right ? across : -across) / width, (top ? along : -along) / height};
  }

  static Eigen::Matrix<double, 3, 12> curvatures(const double x, const double y, const double width,
                                                 const double height) {
    Eigen::Matrix<double, 3, 12> strains = Eigen::Matrix<double, 3, 12>::Zero();
    for (int corner = 0; corner < 4; ++corner) {
      const auto [value, dx, dy] = shape(corner, x, y, width, height);
      strains(0, 3 * corner + 1) = dx;
      strains(1, 3 * corner + 2) = dy;
      strains(2, 3 * corner + 1) = dy;
      strains(2, 3 * corner + 2) = dx;
    }
    return strains;
  }

  static Eigen::Matrix<double, 2, 12> shear_strains(const double width, const double height) {
    Eigen::Matrix<double, 2, 12> strains = Eigen::Matrix<double, 2, 12>::Zero();
    for (int corner = 0; corner < 4; ++corner) {
      const auto [value, dx, dy] = shape(corner, 0.5, 0.5, width, height);
      const Eigen::Index first = 3L * corner;
      strains(0, first) = dx;
      strains(0, first + 1) = -value;
      strains(1, first) = dy;
      strains(1, first + 2) = -value;
    }
    return strains;
  }

  Eigen::Matrix3d bending_;
  double shear_;
};

/// Numbers of the nodes that carry stiffness and are not held.
class PlateGrid {
 public:
  PlateGrid(const HeldPlate& plate, const Point place)
      : plate_(plate), finest_(finest_cells * plate.thickness) {
    find_lines(place);
    numbers_.assign(xs_.size() * ys_.size(), unused);
  }

  /// @throws base::InputError if the plate is not held
  [[nodiscard]] Eigen::SparseMatrix<double> assemble() {
    const Inside inside(plate_.outline);
    const PlateElement element(plate_.thickness, plate_.material);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i + 1 < xs_.size(); ++i)
      for (std::size_t j = 0; j + 1 < ys_.size(); ++j) {
        const double width = xs_[i + 1] - xs_[i];
        const double height = ys_[j + 1] - ys_[j];
        const double part = part_inside(inside, {xs_[i], ys_[j]}, width, height);
        if (part > 0.) append(entries, i, j, part * element.stiffness(width, height));
      }
    if (!is_held_) throw base::InputError("the plate is not held anywhere");
    const Eigen::Index n_dofs = 3L * n_nodes_;
    Eigen::SparseMatrix<double> matrix(n_dofs, n_dofs);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// An even load along a line y = const., for beta_y, whose sum is 1.
  /// @throws base::InputError if the plate does not reach there
  [[nodiscard]] Eigen::VectorXd moment_along(const Point middle, const double length) const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3L * n_nodes_);
    const auto row = static_cast<std::size_t>(
        std::lower_bound(ys_.begin(), ys_.end(), middle.y - finest_ / 4.) - ys_.begin());
    for (std::size_t i = 0; i < xs_.size(); ++i) {
      const double before = i == 0 ? xs_[i] : (xs_[i - 1] + xs_[i]) / 2.;
      const double after = i + 1 == xs_.size() ? xs_[i] : (xs_[i] + xs_[i + 1]) / 2.;
      const double covered =
          std::min(after, middle.x + length / 2.) - std::max(before, middle.x - length / 2.);
      const int number = numbers_[node(i, row)];
      if (number >= 0 && covered > 0.) load[3 * number + 2] = covered;
    }
    if (!(load.sum() > 0.))
      throw base::InputError("the plate does not reach the place of its load");
    return load / load.sum();
  }

 private:
  static constexpr int unused = -1;
  static constexpr int held = -2;

  [[nodiscard]] std::size_t node(const std::size_t i, const std::size_t j) const {
    return i * ys_.size() + j;
  }

  void find_lines(const Point place) {
    Point lower = place;
    Point upper = place;
    for (const Loop& loop : plate_.outline.loops)
      for (const Segment& segment : loop) {
        lower = {std::min(lower.x, segment.start.x), std::min(lower.y, segment.start.y)};
        upper = {std::max(upper.x, segment.start.x), std::max(upper.y, segment.start.y)};
      }
    std::vector<double> marks_x;
    std::vector<double> marks_y;
    for (const Point mark : plate_.marks) {
      marks_x.push_back(mark.x);
      marks_y.push_back(mark.y);
    }
    xs_ = lines_around(place.x, lower.x, upper.x, marks_x, finest_);
    ys_ = lines_around(place.y, lower.y, upper.y, marks_y, finest_);
  }

  void append(std::vector<Eigen::Triplet<double>>& entries, const std::size_t i,
              const std::size_t j, const ElementMatrix& stiffness) {
    const std::array<int, 4> corners{number_of(i, j), number_of(i + 1, j), number_of(i, j + 1),
                                     number_of(i + 1, j + 1)};
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b)
        for (int k = 0; k < 3 && corners[a] >= 0 && corners[b] >= 0; ++k)
          for (int l = 0; l < 3; ++l)
            entries.emplace_back(
                3 * corners[a] + k, 3 * corners[b] + l,
                stiffness(3 * static_cast<int>(a) + k, 3 * static_cast<int>(b) + l));
  }

  int number_of(const std::size_t i, const std::size_t j) {
    int& number = numbers_[node(i, j)];
    if (number != unused) return number;
    if (plate_.is_held({xs_[i], ys_[j]})) {
      is_held_ = true;
      return number = held;
    }
    return number = n_nodes_++;
  }

  const HeldPlate& plate_;
  double finest_;
  Lines xs_;
  Lines ys_;
  std::vector<int> numbers_;
  int n_nodes_ = 0;
  bool is_held_ = false;
};

}  // namespace

double plate_turn(const HeldPlate& plate, const Point place) {
  PlateGrid grid(plate, place);
  const Eigen::SparseMatrix<double> matrix = grid.assemble();
  const Eigen::VectorXd load = grid.moment_along(place, plate.thickness);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const double turn = load.dot(factors.solve(load));
  if (factors.info() != Eigen::Success || !(turn > 0. && std::isfinite(turn)))
    throw base::InputError("the plate has parts that hang together in a point alone");
  return turn;
}

}  // namespace geneva::loads
