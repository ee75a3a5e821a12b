#include "post/output/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "post/output/stress_at.h"

namespace geneva::post {

namespace {

using Place = StressAt::Place;
using SixStresses = std::array<double, 6>;

/// Of the pin from one instant to another.
struct PinMotion {
  double from;  ///< distance of the pin's axis from the wheel's [m]
  double to;
  double cosine;  ///< of the turn
  double sine;

  PinMotion(const PinPosition& one, const PinPosition& other)
      : from(one.distance),
        to(other.distance),
        cosine(std::cos(other.turn - one.turn)),
        sine(-std::sin(other.turn - one.turn)) {}  // clockwise

  [[nodiscard]] Place turned(const Place& direction) const {
    return {cosine * direction[0] - sine * direction[1],
            sine * direction[0] + cosine * direction[1], direction[2]};
  }

  [[nodiscard]] Place moved(const Place& place) const {
    const Place arm = turned({place[0] - from, place[1], place[2]});
    return {to + arm[0], arm[1], arm[2]};
  }
};

NodeMaxima maxima_of(const SixStresses& stress) {
  const PrincipalRange range = principal_range(stress);
  return {von_mises(stress), range.first, 0.5 * (range.first - range.third)};
}

void keep_greater(const double value, const double when, const std::size_t node,
                  std::vector<double>& values, std::vector<double>& times) {
  if (value <= values[node]) return;
  values[node] = value;
  times[node] = when;
}

PinPosition position_of(const CycleFields& instant) {
  return {instant.pin_distance, instant.pin_turn};
}

/// Whether the nodes are the same material points.
bool is_of_same_mesh(const CycleFields& one, const CycleFields& other) {
  return one.pin_distance == other.pin_distance && one.pin_turn == other.pin_turn &&
         one.fields.places == other.fields.places;
}

}  // namespace

void raise(Envelope& envelope, const std::size_t node, const NodeMaxima& stress,
           const double when) {
  keep_greater(stress.von_mises, when, node, envelope.von_mises, envelope.von_mises_when);
  keep_greater(stress.first_principal, when, node, envelope.first_principal,
               envelope.first_principal_when);
  keep_greater(stress.max_shear, when, node, envelope.max_shear, envelope.max_shear_when);
}

EnvelopeOfNodes::EnvelopeOfNodes(const CycleFields& own, std::vector<bool> turning,
                                 std::vector<std::size_t> nodes)
    : own_(own),
      turning_(std::move(turning)),
      bodies_(bodies_of_nodes(own.fields)),
      nodes_(std::move(nodes)) {
  const std::size_t size = nodes_.size();
  const std::vector<double> least(size, std::numeric_limits<double>::lowest());
  const std::vector<double> zeros(size, 0.);
  greatest_ = {least, zeros, least, zeros, least, zeros, zeros};
}

void EnvelopeOfNodes::add(const CycleFields& instant) {
  const bool is_same_mesh = is_of_same_mesh(instant, own_);
  std::optional<StressAt> stress_at;
  if (!is_same_mesh) stress_at.emplace(instant.fields);
  positions_.push_back(position_of(instant));
  const PinMotion motion(position_of(own_), positions_.back());
  NodesUnder& here = stresses_.emplace_back();
  here.reserve(nodes_.size());
  for (const std::size_t node : nodes_) {
    const Place& place = own_.fields.places[node];
    const unsigned int body = bodies_[node];
    const SixStresses stress =
        is_same_mesh ? instant.fields.stress[node]
                     : (*stress_at)(turning_[body] ? motion.moved(place) : place, body);
    here.push_back({stress, maxima_of(stress)});
    raise(greatest_, here.size() - 1, here.back().maxima, instant.when);
  }
}

double EnvelopeOfNodes::least_tension(const std::size_t i, const bool turns) const {
  constexpr double round_off = 1e-9;  // where an instant has no stress, of those that have some
  const auto first = [&](const NodesUnder& at) { return at[i].maxima.first_principal; };
  const auto size = [&](const NodesUnder& at) {
    return std::max(at[i].maxima.von_mises, std::abs(first(at)));
  };
  double greatest = 0.;
  for (const NodesUnder& at : stresses_) greatest = std::max(greatest, size(at));
  if (greatest == 0.) return 0.;
  std::size_t most = stresses_.size();
  for (std::size_t at = 0; at < stresses_.size(); ++at) {
    if (size(stresses_[at]) < round_off * greatest) continue;
    if (most == stresses_.size() || first(stresses_[at]) > first(stresses_[most])) most = at;
  }
  const Place direction = direction_of_first_principal(stresses_[most][i].stress);
  double least = 0.;
  for (std::size_t at = 0; at < stresses_.size(); ++at) {
    const Place there =
        turns ? PinMotion(positions_[most], positions_[at]).turned(direction) : direction;
    least = std::min(least, along(there, stresses_[at][i].stress));
  }
  return least;
}

Envelope EnvelopeOfNodes::result() && {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    greatest_.tension_least[i] = least_tension(i, turning_[bodies_[nodes_[i]]]);
  return std::move(greatest_);
}

Envelope envelope(const CycleFields& own, const std::vector<CycleFields>& instants,
                  const std::vector<bool>& turning) {
  std::vector<std::size_t> nodes(own.fields.places.size());
  std::iota(nodes.begin(), nodes.end(), std::size_t{0});
  EnvelopeOfNodes found(own, turning, std::move(nodes));
  for (const CycleFields& instant : instants) found.add(instant);
  return std::move(found).result();
}

Swing swing_of(const CycleStress& tensile, const std::vector<CycleFields>& instants,
               const std::size_t at, const std::vector<bool>& turning) {
  const bool turns = turning[tensile.body_index];
  const CycleFields& own = instants[at];
  const Place direction =
      direction_of_first_principal(StressAt(own.fields)(tensile.place, tensile.body_index));
  Swing swing{tensile.body, 0., std::nullopt};
  for (const CycleFields& instant : instants) {
    const PinMotion motion(position_of(own), position_of(instant));
    const Place place = turns ? motion.moved(tensile.place) : tensile.place;
    const Place n = turns ? motion.turned(direction) : direction;
    const double stress = along(n, StressAt(instant.fields)(place, tensile.body_index));
    if (stress >= swing.least) continue;
    swing.least = stress;
    swing.driver_angle = instant.when;
  }
  return swing;
}
}  // namespace geneva::post
