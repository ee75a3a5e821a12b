#include "post/output/passing_pressure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace geneva::post {

namespace {

/// Of the sizes: nodes are on a wall or round the pin up to the chords of the mesh.
constexpr double near = 1e-3;
const double quarter_turn = std::acos(0.);

/// The pin's circle and the walls beside it, as the nodes have them.
struct SlotSizes {
  double axis_y;
  double pin_radius;
  double half_width;
};

/// Which nodes belong to bodies that move with the pin.
std::vector<bool> nodes_that_turn(const NodalFields& fields, const std::vector<bool>& turning) {
  std::vector<bool> found(fields.places.size(), false);
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
    for (const std::size_t node : fields.cells[cell]) found[node] = turning[fields.bodies[cell]];
  return found;
}

/// Beside the pin: the distance from the slot's axis that most of the wheel's nodes have, those of
/// the straight walls.
double half_width_of(const CycleFields& own, const std::vector<bool>& turns,
                     const double pin_radius) {
  constexpr double same = 1e-6;
  std::map<long, std::size_t> nodes;
  for (std::size_t node = 0; node < turns.size(); ++node) {
    const auto& place = own.fields.places[node];
    const double from_axis = std::abs(place[1]) / pin_radius;
    const bool is_beside = std::abs(place[0] - own.pin_distance) < 2. * pin_radius;
    if (!turns[node] && is_beside && from_axis > 0.5 && from_axis < 1.5)
      ++nodes[std::lround(from_axis / same)];
  }
  const auto most = std::max_element(
      nodes.begin(), nodes.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  return most == nodes.end() ? 0. : static_cast<double>(most->first) * same * pin_radius;
}

SlotSizes sizes_of(const CycleFields& own, const std::vector<bool>& turns) {
  constexpr double most = std::numeric_limits<double>::max();
  double low = most;
  double high = -most;
  for (std::size_t node = 0; node < turns.size(); ++node) {
    if (!turns[node]) continue;
    low = std::min(low, own.fields.places[node][1]);
    high = std::max(high, own.fields.places[node][1]);
  }
  SlotSizes sizes{(low + high) / 2., (high - low) / 2., 0.};
  sizes.half_width = half_width_of(own, turns, sizes.pin_radius);
  return sizes;
}

/// Where a value passes a goal between two points, as a share of the way.
std::optional<double> share_of_way(const double from, const double to, const double goal) {
  if (from == to || (goal - from) * (goal - to) > 0.) return std::nullopt;
  return (goal - from) / (to - from);
}

/// Of the way from curve point to curve point, when a node is passed.
class Passing {
 public:
  Passing(const CycleFields& own, const SlotSizes& sizes) : own_(own), sizes_(sizes) {}

  [[nodiscard]] bool is_on_wall(const std::array<double, 3>& place) const {
    return std::abs(std::abs(place[1]) - sizes_.half_width) < near * sizes_.pin_radius;
  }
  [[nodiscard]] bool is_round_pin(const std::array<double, 3>& place) const {
    const double radius = std::hypot(place[0] - own_.pin_distance, place[1] - sizes_.axis_y);
    return std::abs(radius - sizes_.pin_radius) < near * sizes_.pin_radius;
  }

  [[nodiscard]] std::optional<double> wall(const std::array<double, 3>& place,
                                           const CycleCurvePoint& from,
                                           const CycleCurvePoint& to) const {
    if ((place[1] > 0.) != (from.force > 0.)) return std::nullopt;
    return share_of_way(from.pin_distance, to.pin_distance, place[0]);
  }

  [[nodiscard]] std::optional<double> pin(const std::array<double, 3>& place,
                                          const CycleCurvePoint& from,
                                          const CycleCurvePoint& to) const {
    const double wall = from.force > 0. ? quarter_turn : -quarter_turn;
    const double now = std::atan2(place[1] - sizes_.axis_y, place[0] - own_.pin_distance);
    const auto beside = [&](const CycleCurvePoint& at) {
      return std::remainder(now - (at.pin_turn - own_.pin_turn) - wall, 4. * quarter_turn);
    };
    if (std::abs(beside(from) - beside(to)) > quarter_turn) return std::nullopt;
    return share_of_way(beside(from), beside(to), 0.);
  }

 private:
  const CycleFields& own_;
  const SlotSizes& sizes_;
};

}  // namespace

PressureEnvelope passing_pressure(const CycleFields& own, const std::vector<bool>& turning,
                                  const std::vector<CycleCurvePoint>& curve) {
  const std::vector<bool> turns = nodes_that_turn(own.fields, turning);
  const SlotSizes sizes = sizes_of(own, turns);
  const Passing passing(own, sizes);
  PressureEnvelope found{std::vector<double>(turns.size(), 0.),
                         std::vector<double>(turns.size(), 0.)};
  for (std::size_t node = 0; node < turns.size(); ++node) {
    const auto& place = own.fields.places[node];
    if (turns[node] ? !passing.is_round_pin(place) : !passing.is_on_wall(place)) continue;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const CycleCurvePoint& from = curve[i];
      const CycleCurvePoint& to = curve[i + 1];
      if ((from.force > 0.) != (to.force > 0.) || to.driver_angle <= from.driver_angle) continue;
      const auto share = turns[node] ? passing.pin(place, from, to) : passing.wall(place, from, to);
      if (!share) continue;
      const double pressure = from.peak_pressure + *share * (to.peak_pressure - from.peak_pressure);
      if (pressure <= found.pressure[node]) continue;
      found.pressure[node] = pressure;
      found.when[node] = from.driver_angle + *share * (to.driver_angle - from.driver_angle);
    }
  }
  return found;
}

}  // namespace geneva::post
