#include "loads/pin/profile_search.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "loads/pi.h"
#include "loads/pin/load_evenness.h"

namespace geneva::loads {

namespace {

/// Of the peak pressure; a maximum mean line load is more accurate.
constexpr double accuracy_of_trials = 1e-3;
/// The scan's steps, by this factor of the size, and where it begins and ends in steps.
const double scan_step = std::log(3.);
constexpr int scan_reach = 1;
constexpr int furthest_step = 6;
/// Brent's method stops when the size is known to 0.4 %: the minimum is flat.
constexpr int search_bits = 9;
constexpr std::uintmax_t most_steps = 30;

double maximum_load(const ProfileDuty& duty, const double size, const double tilt) {
  const PinLine pin = pin_of(duty, size, tilt);
  return load_evenness(pin, pin_line_contact(pin, duty.force, accuracy_of_trials)).maximum;
}

ProfileTrial trial_of(const ProfileDuty& duty, const double size) {
  ProfileTrial trial{size, 0., 0.};
  for (const double tilt : duty.tilts) {
    const double load = maximum_load(duty, size, tilt);
    if (load > trial.line_load) trial = {size, load, tilt};
  }
  return trial;
}

using Objective = std::function<double(double logarithm)>;

/// Logarithms of two sizes with that of the minimum in between: begun around the first size and
/// carried on while the least value is at an end.
/// @param first >= least
std::pair<double, double> bracket(const double first, const double least, const Objective& value) {
  const auto at = [&](const int step) { return std::log(first) + step * scan_step; };
  const auto is_allowed = [&](const int step) { return step == 0 || std::exp(at(step)) >= least; };
  std::map<int, double> values;
  const auto best = [&] {
    return std::min_element(values.begin(), values.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
  };
  for (int step = -scan_reach; step <= scan_reach; ++step)
    if (is_allowed(step)) values[step] = value(at(step));
  for (int step = best()->first; std::abs(step) < furthest_step; step = best()->first) {
    const int next = step == values.begin()->first    ? step - 1
                     : step == values.rbegin()->first ? step + 1
                                                      : step;
    if (next == step || !is_allowed(next)) break;
    values[next] = value(at(next));
  }
  const int below = best()->first - 1;
  return {is_allowed(below) ? at(below) : std::log(least), at(best()->first + 1)};
}

}  // namespace

PinLine pin_of(const ProfileDuty& duty, const double size, const double tilt) {
  PinLine pin = duty.pin;
  pin.clearance.profile = duty.profile(size);
  pin.clearance.tilt = tilt;
  return pin;
}

ProfileSearch find_profile(const ProfileDuty& duty) {
  ProfileSearch search;
  const Objective value = [&](const double logarithm) {
    search.trials.push_back(trial_of(duty, std::exp(logarithm)));
    return search.trials.back().line_load;
  };
  const auto [lower, upper] =
      bracket(std::max(duty.first_size, duty.least_size), duty.least_size, value);
  std::uintmax_t steps = most_steps;
  boost::math::tools::brent_find_minima(value, lower, upper, search_bits, steps);
  search.best = *std::min_element(
      search.trials.begin(), search.trials.end(),
      [](const ProfileTrial& a, const ProfileTrial& b) { return a.line_load < b.line_load; });
  return search;
}

ProfileMap map_around(const ProfileDuty& duty, const double size) {
  constexpr int steps = 8;  // on both sides
  constexpr int most_tilts = 9;
  const double factor = std::pow(2., 0.5);
  const double modulus = contact_modulus(duty.pin.pin, duty.pin.wheel);
  ProfileMap map;
  for (int step = -steps; step <= steps; ++step)
    if (const double tried = size * std::pow(factor, step); tried >= duty.least_size)
      map.sizes.push_back(tried);
  const auto [least, greatest] = std::minmax_element(duty.tilts.begin(), duty.tilts.end());
  const int n_tilts = *least < *greatest ? most_tilts : 1;
  for (int i = 0; i < n_tilts; ++i) {
    map.tilts.push_back(n_tilts == 1 ? *least : *least + (*greatest - *least) * i / (n_tilts - 1.));
    map.pressures.emplace_back();
    for (const double tried : map.sizes)
      map.pressures.back().push_back(std::sqrt(maximum_load(duty, tried, map.tilts.back()) *
                                               modulus / (pi * duty.pin.relative_radius)));
  }
  return map;
}

}  // namespace geneva::loads
