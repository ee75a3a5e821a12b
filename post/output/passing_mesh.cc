#include "post/output/passing_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "post/output/slot_passing.h"

namespace geneva::post {

namespace {

using Corners = std::array<std::size_t, 4>;  // in lexicographic order

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Divides quadrilaterals into four, again and again.
class Division {
 public:
  Division(const CycleFields& own, const std::vector<bool>& turning,
           const std::vector<CycleCurvePoint>& curve, const double half_width_per_pressure,
           const double reach)
      : passing_(own, turning, curve),
        turning_(turning),
        half_width_per_pressure_(half_width_per_pressure),
        reach_(reach),
        least_(least_size * passing_.pin_radius()),
        result_(own) {
    result_.fields.cells.clear();
    result_.fields.bodies.clear();
  }

  CycleFields run(const NodalFields& fields) {
    for (std::size_t cell = 0; cell < fields.cells.size(); ++cell) {
      const auto& nodes = fields.cells[cell];
      divide({nodes[0], nodes[1], nodes[2], nodes[3]}, fields.bodies[cell]);
    }
    return std::move(result_);
  }

 private:
  static constexpr double of_depth = 1.;        // size of a cell
  static constexpr double of_half_width = 0.5;  // the same at the surface
  static constexpr double least_size = 2e-3;    // over the pin's radius: no more can be seen

  void divide(const Corners& corners, const unsigned int body) {
    if (!is_too_large(corners, body)) {
      result_.fields.cells.emplace_back(corners.begin(), corners.end());
      result_.fields.bodies.push_back(body);
      return;
    }
    const bool turns = turning_[body];
    const auto [a, b, c, d] = corners;
    const std::size_t below = between(a, b, turns);
    const std::size_t left = between(a, c, turns);
    const std::size_t right = between(b, d, turns);
    const std::size_t above = between(c, d, turns);
    const std::size_t middle = append({below, left, right, above});
    divide({a, below, left, middle}, body);
    divide({below, b, middle, right}, body);
    divide({left, middle, c, above}, body);
    divide({middle, right, above, d}, body);
  }

  [[nodiscard]] bool is_too_large(const Corners& corners, const unsigned int body) {
    const bool turns = turning_[body];
    const double size = size_of(corners);
    if (size < least_) return false;
    double depth = reach_;
    for (const std::size_t node : corners)
      depth = std::min(depth, std::max(0., passing_.depth(place(node), turns)));
    if (depth >= reach_ || size < of_depth * depth) return false;
    double pressure = 0.;
    for (const std::size_t node : corners)
      pressure = std::max(pressure, passing_pressure(node, turns));
    return pressure > 0. && size > of_half_width * half_width_per_pressure_ * pressure;
  }

  /// 0 where none passes.
  [[nodiscard]] double passing_pressure(const std::size_t node, const bool turns) {
    const auto [known, is_new] = pressures_.try_emplace(node, 0.);
    if (!is_new) return known->second;
    if (const auto pass = passing_.greatest(place(node), turns)) known->second = pass->pressure;
    return known->second;
  }

  [[nodiscard]] double size_of(const Corners& corners) const {
    const auto [a, b, c, d] = corners;
    return std::max({distance(place(a), place(b)), distance(place(c), place(d)),
                     distance(place(a), place(c)), distance(place(b), place(d))});
  }

  [[nodiscard]] const std::array<double, 3>& place(const std::size_t node) const {
    return result_.fields.places[node];
  }

  /// The node in the middle of an edge, on the pin's circle if both ends are.
  std::size_t between(const std::size_t a, const std::size_t b, const bool turns) {
    const auto [known, is_new] = of_edges_.try_emplace(std::minmax(a, b), 0);
    if (!is_new) return known->second;
    const std::size_t node = append({a, b});
    const double on_surface = SlotPassing::near * passing_.pin_radius();
    if (turns && std::abs(passing_.depth(place(a), turns)) < on_surface &&
        std::abs(passing_.depth(place(b), turns)) < on_surface)
      result_.fields.places[node] = passing_.on_pin(place(node));
    return known->second = node;
  }

  /// A node with the mean of others.
  std::size_t append(const std::vector<std::size_t>& others) {
    NodalFields& fields = result_.fields;
    const double share = 1. / static_cast<double>(others.size());
    const auto mean = [&](auto& values) {
      auto sum = values[others.front()];
      sum.fill(0.);
      for (const std::size_t other : others)
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * values[other][i];
      values.push_back(sum);
    };
    mean(fields.places);
    mean(fields.displacements);
    mean(fields.stress);
    double von_mises = 0.;
    for (const std::size_t other : others) von_mises += share * fields.von_mises[other];
    fields.von_mises.push_back(von_mises);
    return fields.places.size() - 1;
  }

  SlotPassing passing_;
  std::vector<bool> turning_;
  double half_width_per_pressure_;
  double reach_;
  double least_;
  CycleFields result_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> of_edges_;
  std::map<std::size_t, double> pressures_;
};

}  // namespace

CycleFields divided_where_passed(const CycleFields& own, const std::vector<bool>& turning,
                                 const std::vector<CycleCurvePoint>& curve,
                                 const double half_width_per_pressure, const double reach) {
  return Division(own, turning, curve, half_width_per_pressure, reach).run(own.fields);
}

}  // namespace geneva::post
