#include "post/output/stress_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geneva::post {

namespace {

namespace bg = boost::geometry;
using Place = StressAt::Place;

/// Solves J x = r of size two or three by Cramer's rule.
Place solved(const std::array<Place, 3>& columns, const Place& r, const std::size_t dim) {
  const auto determinant = [&](const Place& a, const Place& b, const Place& c) {
    if (dim == 2) return a[0] * b[1] - a[1] * b[0];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const auto& [a, b, c] = columns;
  const double whole = determinant(a, b, c);
  if (whole == 0.) return {};
  return {determinant(r, b, c) / whole, determinant(a, r, c) / whole,
          dim == 2 ? 0. : determinant(a, b, r) / whole};
}

}  // namespace

StressAt::StressAt(const NodalFields& fields) : fields_(fields) {
  std::vector<BoxOfCell> boxes;
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
    boxes.emplace_back(box_of(cell), cell);
  tree_ = Tree(boxes.begin(), boxes.end());
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
  constexpr unsigned int nearest_cells = 12;
  if (fields_.bodies[last_] == body) {
    const Weights weights = clamped_weights(last_, place);
    if (distance_to(last_, weights, place) < inside(last_)) return stress_in(last_, weights);
  }
  const auto near = bg::index::nearest(Point(place[0], place[1], place[2]), nearest_cells) &&
                    bg::index::satisfies([&](const BoxOfCell& value) {
                      return fields_.bodies[value.second] == body;
                    });
  double least = std::numeric_limits<double>::max();
  Weights of_nearest{};
  for (auto at = tree_.qbegin(near); at != tree_.qend(); ++at) {  // one by one
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
  constexpr double share = 1e-9;
  const Box box = box_of(cell);
  return share * bg::distance(box.min_corner(), box.max_corner());
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
  const Place there = place_at(cell, weights);
  return std::hypot(there[0] - place[0], there[1] - place[1], there[2] - place[2]);
}

StressAt::Weights StressAt::clamped_weights(const std::size_t cell, const Place& place) const {
  constexpr int most_steps = 8;
  constexpr double settled = 1e-10;  // of the reference cell
  constexpr double difference = 1e-6;
  const std::size_t corners = fields_.cells[cell].size();
  const std::size_t dim = corners == 4 ? 2 : 3;
  Place reference{0.5, 0.5, dim == 2 ? 0. : 0.5};
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
        solved(columns, {place[0] - there[0], place[1] - there[1], place[2] - there[2]}, dim);
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
