#include "loads/motion/slip.h"

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <functional>

namespace geneva::loads {

namespace {

/// Driver angles with the number of the smooth stretch that they are in.
struct Sample {
  std::size_t stretch;
  double driver_angle;
};

/// Between entry, joints and exit; the first and the last of a stretch lie inside of it, because
/// the speed may jump at its ends.
std::vector<Sample> samples(const Mechanism& mechanism) {
  // Reversals are degrees apart, and an engagement has few of them.
  constexpr int intervals = 512;
  constexpr double inset = 1e-10;
  std::vector<double> ends{mechanism.entry};
  ends.insert(ends.end(), mechanism.joints.begin(), mechanism.joints.end());
  ends.push_back(mechanism.exit);
  std::vector<Sample> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    for (int k = 0; k <= intervals; ++k) {
      const double part = k == 0 ? inset : k == intervals ? 1. - inset : double(k) / intervals;
      result.push_back({i, ends[i] + part * (ends[i + 1] - ends[i])});
    }
  return result;
}

double root(const std::function<double(double)>& function, const double begin, const double end) {
  std::uintmax_t steps = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      function, begin, end, boost::math::tools::eps_tolerance<double>(52), steps);
  return (bracket.first + bracket.second) / 2.;
}

}  // namespace

double surface_speed(const Jet& slot_position, const Jet& pin_turn, const double pin_diameter,
                     const Wall wall) {
  if (wall == Wall::none) return 0.;
  const double spin = pin_diameter / 2. * pin_turn.first;
  return slot_position.first + (wall == Wall::driving ? spin : -spin);
}

std::vector<SlipReversal> slip_reversals(const Mechanism& mechanism, const double pin_diameter) {
  const std::vector<Sample> places = samples(mechanism);
  std::vector<SlipReversal> result;
  for (const Wall wall : {Wall::driving, Wall::braking}) {
    const auto speed = [&](const double driver_angle) {
      const SlotMotion motion = mechanism.motion(driver_angle);
      return surface_speed(motion.slot_position, motion.pin_turn, pin_diameter, wall);
    };
    bool was_outwards = speed(places.front().driver_angle) >= 0.;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Sample& before = places[i - 1];
      const Sample& here = places[i];
      const bool is_outwards = speed(here.driver_angle) >= 0.;
      if (is_outwards != was_outwards)
        result.push_back({wall, before.stretch == here.stretch
                                    ? root(speed, before.driver_angle, here.driver_angle)
                                    : mechanism.joints[before.stretch]});
      was_outwards = is_outwards;
    }
  }
  return result;
}

}  // namespace geneva::loads
