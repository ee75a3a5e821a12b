#include "loads/design/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

namespace {

DesignedWheel loaded(const DesignInput& input, DesignedWheel wheel) {
  const double arm = johnson_row(input.dimensions.stations).k * wheel.diameter;
  wheel.force = pin_force(wheel.inertia, input.load, design_acceleration(input), arm);
  wheel.peak_pressure =
      johnson_stress(wheel.force, wheel.thickness, wheel.pin_diameter, input.pin, input.wheel);
  return wheel;
}

/// Nothing where no wheel of the diameter can be drawn.
std::optional<DesignedWheel> drawn_if_possible(const DesignInput& input, const double diameter) {
  try {
    return drawn_wheel(input, diameter);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Stress of the drawn wheel; infinite where there is none, so that a search turns back.
double drawn_stress(const DesignInput& input, const double diameter) {
  const auto wheel = drawn_if_possible(input, diameter);
  return wheel ? wheel->peak_pressure : std::numeric_limits<double>::infinity();
}

/// Eq. 9 with a positive result.
double required_inertia(const DesignInput& input) {
  const double inertia = optimum_wheel_inertia(input.load, design_acceleration(input));
  if (inertia > 0.) return inertia;
  throw base::InputError(
      "load inertia and friction moment are both 0: the contact stress then falls with the "
      "wheel's diameter and no wheel is the best one; give the load's inertia or the friction");
}

double log_step(const double first, const double last, const int step, const int steps) {
  return first * std::pow(last / first, static_cast<double>(step) / steps);
}

/// The minimum stress between two diameters that enclose one minimum: the worse third is cut off.
double ternary_search(const DesignInput& input, double lower, double upper) {
  // nearer together rounding decides which of the two stresses is the smaller one
  while (upper - lower > 1e-7 * upper) {
    const double left = lower + (upper - lower) / 3.;
    const double right = upper - (upper - lower) / 3.;
    if (drawn_stress(input, left) < drawn_stress(input, right))
      upper = right;
    else
      lower = left;
  }
  return upper;
}

/// Diameter of the minimum stress near a first guess.
double searched_diameter(const DesignInput& input, const double guess) {
  constexpr int steps = 400;
  constexpr double span = 10.;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= steps; ++step) {
    const double stress = drawn_stress(input, log_step(guess / span, guess * span, step, steps));
    if (stress < least) best = step;
    least = std::min(least, stress);
  }
  if (!std::isfinite(least)) drawn_wheel(input, guess);  // says why there is none
  const double diameter = log_step(guess / span, guess * span, best, steps);
  const double found = ternary_search(input, log_step(guess / span, guess * span, best - 1, steps),
                                      log_step(guess / span, guess * span, best + 1, steps));
  // where so few diameters can be drawn that the search misses them
  return drawn_stress(input, found) < least ? found : diameter;
}

}  // namespace

GenevaDimensionsInput resized(const GenevaDimensionsInput& input, const GivenLengths rule,
                              const double diameter) {
  GenevaDimensionsInput result = input;
  result.wheel_diameter = diameter;
  result.crank_radius.reset();
  result.centre_distance.reset();
  if (rule == GivenLengths::stay) return result;
  const double scale = diameter / complete_dimensions(input).wheel_diameter;
  for (std::optional<double>* length :
       {&result.pin_diameter, &result.thickness, &result.slot_clearance, &result.slot_width,
        &result.slot_depth, &result.locking_radius, &result.bore_radius, &result.pin_core_radius})
    if (*length) **length *= scale;
  return result;
}

double design_acceleration(const DesignInput& input) {
  require_positive("driver speed", input.driver_speed, "rad/s");
  return johnson_row(input.dimensions.stations).peak_acceleration_ratio * input.driver_speed *
         input.driver_speed;
}

DesignedWheel johnson_wheel(const DesignInput& input, const double diameter) {
  const JohnsonRow row = johnson_row(input.dimensions.stations);
  DesignedWheel wheel{};
  wheel.diameter = diameter;
  wheel.pin_diameter = row.k2 * diameter;
  wheel.thickness = row.k3 * diameter;
  wheel.locking_radius = row.k4 * diameter;
  wheel.inertia = johnson_wheel_inertia(johnson_k5(row), input.density, diameter);
  return loaded(input, wheel);
}

DesignedWheel drawn_wheel(const DesignInput& input, const double diameter) {
  const GenevaDimensions dimensions =
      complete_dimensions(resized(input.dimensions, input.given_lengths, diameter));
  DesignedWheel wheel{};
  wheel.diameter = diameter;
  wheel.pin_diameter = dimensions.pin_diameter;
  wheel.thickness = dimensions.thickness;
  wheel.locking_radius = dimensions.locking_radius;
  wheel.inertia = wheel_inertia(dimensions, input.density);
  return loaded(input, wheel);
}

std::optional<DesignedWheel> johnson_optimum(const DesignInput& input) {
  const JohnsonRow row = johnson_row(input.dimensions.stations);
  required_inertia(input);
  if (!row.k5) return std::nullopt;
  return johnson_wheel(input, optimum_wheel_diameter(input.load, design_acceleration(input),
                                                     *row.k5, input.density));
}

DrawnOptimum drawn_optimum(const DesignInput& input) {
  const double required = required_inertia(input);
  const GenevaDimensions own = complete_dimensions(input.dimensions);
  const double k5 =
      wheel_inertia(own, input.density) / (input.density * std::pow(own.wheel_diameter, 5));
  double diameter =
      optimum_wheel_diameter(input.load, design_acceleration(input), k5, input.density);
  if (input.given_lengths == GivenLengths::stay) diameter = searched_diameter(input, diameter);
  const DesignedWheel wheel = drawn_wheel(input, diameter);
  constexpr double beside = 1e-5;  // a hundred times the search's tolerance
  const bool at_limit = !drawn_if_possible(input, diameter * (1. + beside)) ||
                        !drawn_if_possible(input, diameter * (1. - beside));
  return {wheel, 1.5 * wheel.inertia / required, at_limit};
}

std::vector<DesignPoint> design_curve(const DesignInput& input, const double first,
                                      const double last, const int steps) {
  require_positive_length("first diameter", first);
  require_positive_length("last diameter", last - first);
  require_positive("number of steps", steps, "");
  design_acceleration(input);  // refuses what no diameter could mend
  const bool has_johnson = johnson_row(input.dimensions.stations).k5.has_value();
  std::vector<DesignPoint> curve;
  for (int step = 0; step <= steps; ++step) {
    DesignPoint point{log_step(first, last, step, steps), std::nullopt, std::nullopt};
    if (has_johnson) point.johnson = johnson_wheel(input, point.diameter);
    point.drawn = drawn_if_possible(input, point.diameter);
    curve.push_back(point);
  }
  return curve;
}

std::vector<DesignTableRow> design_table() {
  std::vector<DesignTableRow> table;
  for (int stations = 3; stations <= 24; ++stations) {
    GenevaDimensionsInput input{};
    input.stations = stations;
    input.wheel_diameter = 1.;
    const GenevaDimensions wheel = complete_dimensions(input);
    Outline outline = wheel_outline(wheel);
    outline.loops.resize(1);  // the others are holes: the bore, which Johnson does not have
    table.push_back({johnson_row(stations), wheel.thickness * area_moments(outline).polar_moment});
  }
  return table;
}

WorkingCycle working_cycle(const int stations, const double driver_speed) {
  const int n = require_stations(stations);
  require_positive("driver speed", driver_speed, "rad/s");
  WorkingCycle cycle{};
  cycle.motion_fraction = (n - 2.) / (2. * n);
  cycle.time_ratio = (n - 2.) / (n + 2.);
  const double turn = 2. * pi / driver_speed;
  cycle.motion_time = cycle.motion_fraction * turn;
  cycle.dwell_time = turn - cycle.motion_time;
  cycle.maximum_pins = 2 * n / (n - 2);
  return cycle;
}

}  // namespace geneva::loads
