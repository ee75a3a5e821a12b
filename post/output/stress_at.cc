#include "post/output/stress_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geneva::post {

namespace {

namespace bg = boost::geometry;
using Place = StressAt::Place;

constexpr int most_steps = 8;      // of Newton's method
constexpr double settled = 1e-10;  // of the reference cell
/// Of the diagonal of a cell's box: as far outside of the cell a place is within it.
constexpr double share_within = 1e-9;

double distance_between(const Place& one, const Place& other) {
  double square = 0.;
  for (std::size_t i = 0; i < 3; ++i) square += (one[i] - other[i]) * (one[i] - other[i]);
  return std::sqrt(square);
}

/// Solves J x = r by Cramer's rule.
Place solved(const std::array<Place, 3>& columns, const Place& r) {
  const auto determinant = [](const Place& a, const Place& b, const Place& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const auto& [a, b, c] = columns;
  const double whole = determinant(a, b, c);
  if (whole == 0.) return {};
  return {determinant(r, b, c) / whole, determinant(a, r, c) / whole, determinant(a, b, r) / whole};
}

}  // namespace

StressAt::StressAt(const NodalFields& fields) : fields_(fields) {
  std::vector<BoxOfCell> numbered;
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell) {
    boxes_.push_back(box_of(cell));
    numbered.emplace_back(boxes_.back(), cell);
  }
  tree_ = Tree(numbered.begin(), numbered.end());
}

StressAt::Weights StressAt::weights_at(const Place& reference, const std::size_t corners) {
  Weights weights{};
  for (std::size_t corner = 0; corner < corners; ++corner) {
    weights[corner] = 1.;
    for (std::size_t axis = 0; (std::size_t{1} << axis) < corners; ++axis)
      weights[corner] *= (corner >> axis & 1U) != 0 ? reference[axis] : 1. - reference[axis];
  }
  return weights;
}

std::array<double, 6> StressAt::operator()(const Place& place, const unsigned int body) const {
  if (const auto weights = weights_within(last_, place, body)) return stress_in(last_, *weights);
  const auto boxes = bg::index::intersects(Point(place[0], place[1], place[2]));
  for (auto at = tree_.qbegin(boxes); at != tree_.qend(); ++at)
    if (const auto weights = weights_within(at->second, place, body)) {
      last_ = at->second;
      return stress_in(last_, *weights);
    }
  return stress_in_nearest(place, body);
}

std::optional<StressAt::Weights> StressAt::weights_within(const std::size_t cell,
                                                          const Place& place,
                                                          const unsigned int body) const {
  if (fields_.bodies[cell] != body ||
      !bg::covered_by(Point(place[0], place[1], place[2]), boxes_[cell]))
    return std::nullopt;
  const Weights weights = clamped_weights(cell, place);
  if (distance_to(cell, weights, place) >= inside(cell)) return std::nullopt;
  return weights;
}

std::array<double, 6> StressAt::stress_in_nearest(const Place& place,
                                                  const unsigned int body) const {
  constexpr unsigned int nearest_cells = 12;
  const Point point(place[0], place[1], place[2]);
  const auto near =
      bg::index::nearest(point, nearest_cells) && bg::index::satisfies([&](const BoxOfCell& value) {
        return fields_.bodies[value.second] == body;
      });
  double least = std::numeric_limits<double>::max();
  Weights of_nearest{};
  for (auto at = tree_.qbegin(near); at != tree_.qend(); ++at) {  // one by one
    if (bg::distance(point, at->first) >= least) break;           // so are all the others
    const std::size_t cell = at->second;
    const Weights weights = clamped_weights(cell, place);
    const double distance = distance_to(cell, weights, place);
    if (distance >= least) continue;
    least = distance;
    last_ = cell;
    of_nearest = weights;
    if (distance < inside(cell)) break;
  }
  return stress_in(last_, of_nearest);
}

std::array<double, 6> StressAt::stress_in(const std::size_t cell, const Weights& weights) const {
  std::array<double, 6> stress{};
  for (std::size_t corner = 0; corner < fields_.cells[cell].size(); ++corner)
    for (std::size_t i = 0; i < 6; ++i)
      stress[i] += weights[corner] * fields_.stress[fields_.cells[cell][corner]][i];
  return stress;
}

double StressAt::inside(const std::size_t cell) const {
  const Box& box = boxes_[cell];
  return share_within * bg::distance(box.min_corner(), box.max_corner());
}

StressAt::Box StressAt::box_of(const std::size_t cell) const {
  Place low;
  Place high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const std::size_t node : fields_.cells[cell])
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], fields_.places[node][i]);
      high[i] = std::max(high[i], fields_.places[node][i]);
    }
  // A place on a face of the boundary is not to fall out of the box by its rounding.
  const double margin = share_within * distance_between(low, high);
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] -= margin;
    high[i] += margin;
  }
  return {Point(low[0], low[1], low[2]), Point(high[0], high[1], high[2])};
}

StressAt::Place StressAt::place_at(const std::size_t cell, const Weights& weights) const {
  Place place{};
  for (std::size_t corner = 0; corner < fields_.cells[cell].size(); ++corner)
    for (std::size_t i = 0; i < 3; ++i)
      place[i] += weights[corner] * fields_.places[fields_.cells[cell][corner]][i];
  return place;
}

double StressAt::distance_to(const std::size_t cell, const Weights& weights,
                             const Place& place) const {
  return distance_between(place_at(cell, weights), place);
}

StressAt::Weights StressAt::clamped_weights(const std::size_t cell, const Place& place) const {
  return fields_.cells[cell].size() == 4 ? clamped_in_plane(cell, place)
                                         : clamped_in_space(cell, place);
}

StressAt::Weights StressAt::clamped_in_plane(const std::size_t cell, const Place& place) const {
  const auto corner = [&](const std::size_t i) -> const Place& {
    return fields_.places[fields_.cells[cell][i]];
  };
  const auto along = [&](const std::size_t axis) {  // p = constant + x a + y b + x y c
    return std::array<double, 4>{
        corner(0)[axis] - place[axis], corner(1)[axis] - corner(0)[axis],
        corner(2)[axis] - corner(0)[axis],
        corner(0)[axis] - corner(1)[axis] - corner(2)[axis] + corner(3)[axis]};
  };
  const std::array<double, 4> first = along(0);
  const std::array<double, 4> second = along(1);
  double x = 0.5;
  double y = 0.5;
  double largest = 1.;
  for (int step = 0; step < most_steps && largest > settled; ++step) {
    const auto value = [&](const std::array<double, 4>& p) {
      return p[0] + x * p[1] + y * p[2] + x * y * p[3];
    };
    const double by_x[] = {first[1] + y * first[3], second[1] + y * second[3]};
    const double by_y[] = {first[2] + x * first[3], second[2] + x * second[3]};
    const double whole = by_x[0] * by_y[1] - by_x[1] * by_y[0];
    if (whole == 0.) break;
    const double change_x = (value(second) * by_y[0] - value(first) * by_y[1]) / whole;
    const double change_y = (value(first) * by_x[1] - value(second) * by_x[0]) / whole;
    x = std::clamp(x + change_x, -1., 2.);
    y = std::clamp(y + change_y, -1., 2.);
    largest = std::max(std::abs(change_x), std::abs(change_y));
  }
  return weights_at({std::clamp(x, 0., 1.), std::clamp(y, 0., 1.), 0.}, 4);
}

StressAt::Weights StressAt::clamped_in_space(const std::size_t cell, const Place& place) const {
  constexpr double difference = 1e-6;
  constexpr std::size_t corners = 8;
  constexpr std::size_t dim = 3;
  Place reference{0.5, 0.5, 0.5};
  double largest = 1.;
  for (int step = 0; step < most_steps && largest > settled; ++step) {
    const Place there = place_at(cell, weights_at(reference, corners));
    std::array<Place, 3> columns{};
    for (std::size_t axis = 0; axis < dim; ++axis) {
      Place beside = reference;
      beside[axis] += difference;
      const Place moved = place_at(cell, weights_at(beside, corners));
      for (std::size_t i = 0; i < 3; ++i) columns[axis][i] = (moved[i] - there[i]) / difference;
    }
    const Place change =
        solved(columns, {place[0] - there[0], place[1] - there[1], place[2] - there[2]});
    largest = 0.;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      reference[axis] = std::clamp(reference[axis] + change[axis], -1., 2.);
      largest = std::max(largest, std::abs(change[axis]));
    }
  }
  for (std::size_t axis = 0; axis < dim; ++axis)
    reference[axis] = std::clamp(reference[axis], 0., 1.);
  return weights_at(reference, corners);
}

}  // namespace geneva::post
