#include "loads/design/johnson.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

struct Proportions {
  double k2;
  double k3;
  double k4;
  std::optional<double> k5;
};

/// Johnson's suggested constants, n = 3..10; beyond, those of n = 10 shrink with the pitch.
Proportions proportions(int stations) {
  static const std::array<Proportions, 8> table{{{0.16, 0.16, 0.70, 0.00353},
                                                 {0.15, 0.15, 0.35, 0.00506},
                                                 {0.14, 0.14, 0.24, 0.00516},
                                                 {0.14, 0.14, 0.17, 0.00588},
                                                 {0.14, 0.14, 0.13, 0.00573},
                                                 {0.13, 0.13, 0.10, 0.00575},
                                                 {0.12, 0.12, 0.08, 0.00584},
                                                 {0.10, 0.10, 0.08, 0.00540}}};
  if (stations <= 10) return table[static_cast<std::size_t>(stations - 3)];
  const double scale = std::sin(pi / stations) / std::sin(pi / 10.);
  const Proportions& last = table.back();
  return {scale * last.k2, scale * last.k3, scale * last.k4, std::nullopt};
}

void check_load(const WheelLoad& load) {
  require_not_negative("load inertia", load.load_inertia, "kg m^2");
  require_not_negative("friction moment", load.friction_moment, "N m");
}

double wheel_diameter(const CommonDimensionsInput& input) {
  const int given = int{input.wheel_diameter.has_value()} + int{input.crank_radius.has_value()} +
                    int{input.centre_distance.has_value()};
  if (given != 1)
    throw base::InputError(fmt::format(
        "{} of wheel diameter, crank radius and centre distance are given: the size follows from "
        "exactly one of them; give one",
        given));
  const double half_pitch = pi / input.stations;
  if (input.crank_radius) return 2. * *input.crank_radius / std::tan(half_pitch);
  if (input.centre_distance) return 2. * *input.centre_distance * std::cos(half_pitch);
  return *input.wheel_diameter;
}

double slot_width(const CommonDimensionsInput& input, double pin_diameter) {
  if (input.slot_width && input.slot_clearance)
    throw base::InputError(fmt::format(
        "slot width {:.6g} mm and slot clearance {:.6g} mm are both given: one follows from the "
        "other and the pin diameter; give one of them",
        1e3 * *input.slot_width, 1e3 * *input.slot_clearance));
  if (input.slot_width) return *input.slot_width;
  const double clearance = input.slot_clearance.value_or(0.);
  require_not_negative("slot clearance", 1e3 * clearance, "mm");
  return pin_diameter + clearance;
}

/// All but the slot's depth, whose default depends on the kind of wheel.
CommonDimensions complete_common(const CommonDimensionsInput& input) {
  const JohnsonRow row = johnson_row(input.stations);
  CommonDimensions result{};
  result.stations = input.stations;
  result.wheel_diameter = wheel_diameter(input);
  const double radius = result.wheel_diameter / 2.;
  const double half_pitch = pi / input.stations;
  result.crank_radius = radius * std::tan(half_pitch);
  result.centre_distance = radius / std::cos(half_pitch);
  result.pin_diameter = input.pin_diameter.value_or(row.k2 * result.wheel_diameter);
  result.thickness = input.thickness.value_or(row.k3 * result.wheel_diameter);
  result.slot_width = slot_width(input, result.pin_diameter);
  result.locking_radius = input.locking_radius.value_or(row.k4 * result.wheel_diameter);
  result.pin_core_radius = input.pin_core_radius.value_or(result.pin_diameter / 4.);
  return result;
}

}  // namespace

JohnsonRow johnson_row(int stations) {
  const ExternalGeneva geneva(stations);
  const double beta = geneva.peak_acceleration_angle();
  const double arm = geneva.pin_distance_ratio(beta) / (2. * std::cos(geneva.half_pitch()));
  const Proportions suggested = proportions(stations);
  return {stations,
          beta,
          geneva.acceleration_ratio(-beta),
          std::tan(geneva.half_pitch()),
          arm,
          suggested.k2,
          suggested.k3,
          suggested.k4,
          suggested.k5,
          suggested.k5.has_value()};
}

MechanismSizes mechanism_sizes(const Mechanism& mechanism,
                               const std::optional<double>& pin_diameter,
                               const std::optional<double>& thickness) {
  const JohnsonRow row = johnson_row(mechanism.stations);
  const double diameter = 2. * mechanism.motion(mechanism.entry).pin_distance.value;
  return {diameter, pin_diameter.value_or(row.k2 * diameter),
          thickness.value_or(row.k3 * diameter)};
}

double johnson_k5(const JohnsonRow& row) {
  if (row.k5) return *row.k5;
  throw base::InputError(fmt::format(
      "number of stations is {}: Johnson gives k5 for 3 to 10 only; take fewer stations or the "
      "inertia of the drawn wheel",
      row.stations));
}

double pin_force(double wheel_inertia, const WheelLoad& load, double wheel_acceleration,
                 double arm) {
  require_not_negative("wheel inertia", wheel_inertia, "kg m^2");
  check_load(load);
  require_finite("wheel acceleration", wheel_acceleration, "rad/s^2");
  require_positive_length("arm of the pin force", arm);
  return ((wheel_inertia + load.load_inertia) * wheel_acceleration + load.friction_moment) / arm;
}

double johnson_wheel_inertia(double k5, double density, double wheel_diameter) {
  require_positive("k5", k5, "");
  require_positive("density", density, "kg/m^3");
  require_positive_length("wheel diameter", wheel_diameter);
  return k5 * density * std::pow(wheel_diameter, 5);
}

double johnson_stress(double force, double thickness, double pin_diameter, const Elastic& pin,
                      const Elastic& wheel) {
  require_positive("pin force", force, "N");
  require_positive_length("thickness", thickness);
  require_positive_length("pin diameter", pin_diameter);
  const double k1 = std::sqrt(2. / pi * contact_modulus(pin, wheel));
  return k1 * std::sqrt(force / (thickness * pin_diameter));
}

double johnson_stress_of_diameter(double wheel_diameter, const JohnsonRow& row,
                                  const WheelLoad& load, double peak_acceleration, double density,
                                  const Elastic& pin, const Elastic& wheel) {
  const double inertia = johnson_wheel_inertia(johnson_k5(row), density, wheel_diameter);
  const double force = pin_force(inertia, load, peak_acceleration, row.k * wheel_diameter);
  return johnson_stress(force, row.k3 * wheel_diameter, row.k2 * wheel_diameter, pin, wheel);
}

double optimum_wheel_inertia(const WheelLoad& load, double peak_acceleration) {
  check_load(load);
  require_positive("peak acceleration", peak_acceleration, "rad/s^2");
  return 1.5 * (load.load_inertia + load.friction_moment / peak_acceleration);
}

double optimum_wheel_diameter(const WheelLoad& load, double peak_acceleration, double k5,
                              double density) {
  require_positive("k5", k5, "");
  require_positive("density", density, "kg/m^3");
  return std::pow(optimum_wheel_inertia(load, peak_acceleration) / (k5 * density), 0.2);
}

double solid_cylinder_inertia(double diameter, double length, double density) {
  require_positive_length("cylinder diameter", diameter);
  require_positive_length("cylinder length", length);
  require_positive("density", density, "kg/m^3");
  return density * pi * std::pow(diameter, 4) * length / 32.;
}

GenevaDimensions complete_dimensions(const GenevaDimensionsInput& input) {
  GenevaDimensions result{complete_common(input), 0.};
  const double radius = result.wheel_diameter / 2.;
  const double nearest = result.centre_distance - result.crank_radius;
  result.slot_depth = input.slot_depth.value_or(radius - nearest + result.slot_width / 2.);
  const double lowest = radius - result.slot_depth;
  result.bore_radius =
      input.bore_radius.value_or(std::min(0.1 * result.wheel_diameter, lowest / 2.));
  check(result);
  return result;
}

InternalDimensions complete_internal_dimensions(const InternalDimensionsInput& input) {
  InternalDimensions result{complete_common(input), 0.};
  const double radius = result.wheel_diameter / 2.;
  const double farthest = result.centre_distance + result.crank_radius;
  result.slot_depth = input.slot_depth.value_or(farthest - radius + result.slot_width / 2.);
  result.rim_radius =
      input.rim_radius.value_or(radius + result.slot_depth + 0.15 * result.wheel_diameter);
  check(result);
  return result;
}

}  // namespace geneva::loads
