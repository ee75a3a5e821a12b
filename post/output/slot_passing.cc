#include "post/output/slot_passing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace geneva::post {

namespace {

const double quarter_turn = std::acos(0.);

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

/// Where a value passes a goal between two points, as a share of the way.
std::optional<double> share_of_way(const double from, const double to, const double goal) {
  if (from == to || (goal - from) * (goal - to) > 0.) return std::nullopt;
  return (goal - from) / (to - from);
}

}  // namespace

std::vector<bool> nodes_that_turn(const NodalFields& fields, const std::vector<bool>& turning) {
  std::vector<bool> found(fields.places.size(), false);
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
    for (const std::size_t node : fields.cells[cell]) found[node] = turning[fields.bodies[cell]];
  return found;
}

SlotPassing::SlotPassing(const CycleFields& own, const std::vector<bool>& turning,
                         const std::vector<CycleCurvePoint>& curve)
    : pin_distance_(own.pin_distance) {
  const std::vector<bool> turns = nodes_that_turn(own.fields, turning);
  double low = std::numeric_limits<double>::max();
  double high = -low;
  for (std::size_t node = 0; node < turns.size(); ++node) {
    if (!turns[node]) continue;
    low = std::min(low, own.fields.places[node][1]);
    high = std::max(high, own.fields.places[node][1]);
  }
  axis_y_ = (low + high) / 2.;
  pin_radius_ = (high - low) / 2.;
  half_width_ = half_width_of(own, turns, pin_radius_);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const CycleCurvePoint& from = curve[i];
    const CycleCurvePoint& to = curve[i + 1];
    if ((from.force > 0.) != (to.force > 0.) || to.driver_angle <= from.driver_angle) continue;
    const double wall = from.force > 0. ? quarter_turn : -quarter_turn;
    const auto facing = [&](const CycleCurvePoint& at) {
      return at.pin_turn - own.pin_turn + wall;
    };
    ways_.push_back({from, to, {facing(from), facing(to)}});
  }
}

double SlotPassing::depth(const Place& place, const bool turns) const {
  if (!turns) return std::abs(place[1]) - half_width_;
  return pin_radius_ - std::hypot(place[0] - pin_distance_, place[1] - axis_y_);
}

SlotPassing::Place SlotPassing::on_pin(const Place& place) const {
  const double x = place[0] - pin_distance_;
  const double y = place[1] - axis_y_;
  const double factor = pin_radius_ / std::hypot(x, y);
  return {pin_distance_ + factor * x, axis_y_ + factor * y, place[2]};
}

std::optional<Pass> SlotPassing::greatest(const Place& place, const bool turns) const {
  const double angle = std::atan2(place[1] - axis_y_, place[0] - pin_distance_);
  std::optional<Pass> found;
  for (const Way& way : ways_) {
    const auto& [from, to, facing] = way;
    const double greatest_yet = found ? found->pressure : 0.;
    if (!(std::max(from.peak_pressure, to.peak_pressure) > greatest_yet)) continue;
    const auto share = share_of(way, place, turns, angle);
    if (!share) continue;
    const double pressure = from.peak_pressure + *share * (to.peak_pressure - from.peak_pressure);
    if (!(pressure > greatest_yet)) continue;
    found = {pressure, from.driver_angle + *share * (to.driver_angle - from.driver_angle)};
  }
  return found;
}

std::optional<double> SlotPassing::share_of(const Way& way, const Place& place, const bool turns,
                                            const double angle) const {
  const auto& [from, to, facing] = way;
  if (!turns) {
    if ((place[1] > 0.) != (from.force > 0.)) return std::nullopt;
    return share_of_way(from.pin_distance, to.pin_distance, place[0]);
  }
  const double turn = facing[1] - facing[0];
  if (std::abs(turn) > quarter_turn) return std::nullopt;
  const double beside = std::remainder(angle - facing[0], 4. * quarter_turn);
  return share_of_way(0., turn, beside);
}

}  // namespace geneva::post
