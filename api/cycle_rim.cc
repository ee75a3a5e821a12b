#include "api/cycle_rim.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "api/cycle_instant.h"
#include "loads/pi.h"

namespace geneva::api {

namespace {

/// Where the pin enters or leaves its slot it touches the corner of the rim, whose pressure has no
/// bound: the instant moves inwards to where the pin touches the wall.
/// @param neighbour time of the next instant inwards
void move_off_rim(loads::CycleInstant& instant, const Case& given,
                  const model::MechanismDynamics& dynamics, const double neighbour) {
  constexpr int halvings = 20;
  constexpr double share_beyond = 0.1;  // of the way on to the neighbour
  const auto load_at = [&](const double time) {
    return loads::pin_load(dynamics.driven.at_time(time), dynamics.train);
  };
  double outside = instant.load.time;
  double inside = neighbour;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (outside + inside);
    (touches_wall(given, load_at(middle)) ? inside : outside) = middle;
  }
  instant.load = load_at(inside + share_beyond * (neighbour - inside));
}

}  // namespace

std::vector<std::string> keep_off_rim(std::vector<loads::CycleInstant>& instants, const Case& given,
                                      const model::MechanismDynamics& dynamics) {
  std::vector<std::string> notes;
  std::vector<loads::CycleInstant> kept;
  std::optional<loads::CycleInstant> outside;  // that waits for its neighbour inwards
  const auto tell = [&](const loads::CycleInstant& instant, const std::string& what) {
    notes.push_back(fmt::format(
        "at {:.6g} deg ({}) the pin touches the corner of the slot's rim, where no pressure is "
        "bounded: {}",
        instant.load.driver_angle / loads::degree, loads::name_of(instant.role), what));
  };
  const auto move = [&](loads::CycleInstant instant, const loads::CycleInstant& neighbour) {
    const loads::CycleInstant before = instant;
    if (neighbour.engagement != instant.engagement || neighbour.load.wall != instant.load.wall) {
      tell(before, "left out");
      return;
    }
    move_off_rim(instant, given, dynamics, neighbour.load.time);
    tell(before, fmt::format("solved at {:.6g} deg, on the wall",
                             instant.load.driver_angle / loads::degree));
    kept.push_back(instant);
  };
  for (const loads::CycleInstant& instant : instants) {
    const bool touches = touches_wall(given, instant.load);
    if (touches) {
      if (outside) move(*outside, instant);
      outside.reset();
      kept.push_back(instant);
    } else if (instant.role == loads::InstantRole::exit && !kept.empty()) {
      move(instant, loads::CycleInstant(kept.back()));
    } else if (instant.role == loads::InstantRole::entry) {
      outside = instant;
    } else {
      tell(instant, "left out");
    }
  }
  instants = std::move(kept);
  return notes;
}

}  // namespace geneva::api
