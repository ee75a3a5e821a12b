#include "model/mechanism_motion.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "loads/design/johnson.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"

namespace geneva::model {

namespace {

using Kind = MechanismCase::Kind;

/// Crank radius of a plane mechanism, from whichever size is given: r = (D/2) tan(pi/n), c = r/sin.
double crank_radius(const loads::GenevaDimensionsInput& input) {
  const double half_pitch = loads::pi / input.stations;
  if (input.crank_radius) return *input.crank_radius;
  if (input.centre_distance) return *input.centre_distance * std::sin(half_pitch);
  return *input.wheel_diameter / 2. * std::tan(half_pitch);
}

double centre_distance(const loads::GenevaDimensionsInput& input) {
  return input.centre_distance ? *input.centre_distance
                               : crank_radius(input) / std::sin(loads::pi / input.stations);
}

loads::FourBarGeneva four_bar(const MechanismCase& given) {
  return loads::four_bar_geneva(given.dimensions.stations, given.linkage, given.assembly,
                                given.wheel_place);
}

loads::Drive drive_of(const MechanismCase& given, const loads::Mechanism& mechanism,
                      const std::vector<loads::Engagement>& engagements) {
  const DriverMotion& motion = given.motion;
  switch (motion.kind) {
    case DriverMotion::Kind::constant:
      return loads::constant_acceleration(mechanism, engagements, motion.speed,
                                          motion.acceleration);
    case DriverMotion::Kind::table:
      return loads::table(engagements, motion.times, motion.angles);
    case DriverMotion::Kind::law_on_carrier:
      return loads::law_on_carrier(mechanism, engagements, motion.law, motion.motion_time);
    case DriverMotion::Kind::law_on_cross:
      return loads::law_on_cross(mechanism,
                                 given.kind == Kind::internal ? loads::PlaneGeneva::internal
                                                              : loads::PlaneGeneva::external,
                                 centre_distance(given.dimensions), engagements, motion.law,
                                 motion.motion_time);
  }
  throw std::logic_error("unknown kind of driver motion");
}

}  // namespace

loads::Mechanism mechanism_of(const MechanismCase& given) {
  const int stations = given.dimensions.stations;
  switch (given.kind) {
    case Kind::external:
      return loads::external_geneva(stations, centre_distance(given.dimensions));
    case Kind::internal:
      return loads::internal_geneva(stations, centre_distance(given.dimensions));
    case Kind::spherical:
      return loads::spherical_geneva(stations, given.shaft_angle, given.sphere_radius);
    case Kind::long_dwell:
      return loads::long_dwell_geneva(stations, crank_radius(given.dimensions),
                                      given.sprocket_spacing, given.sprocket_line);
    case Kind::four_bar:
      return four_bar(given).mechanism;
  }
  throw std::logic_error("unknown kind of mechanism");
}

std::vector<loads::Engagement> engagements_of(const MechanismCase& given,
                                              const loads::Mechanism& with) {
  return loads::engagements(with, given.pin_angles.empty()
                                      ? loads::equally_spaced_pins(with, given.pins)
                                      : given.pin_angles);
}

loads::DrivenMechanism driven_mechanism(const MechanismCase& given) {
  const loads::Mechanism mechanism = mechanism_of(given);
  const auto engagements = engagements_of(given, mechanism);
  return {mechanism, engagements, drive_of(given, mechanism, engagements)};
}

MechanismSizes sizes_of(const MechanismCase& given) {
  const loads::Mechanism mechanism = mechanism_of(given);
  const loads::JohnsonRow row = loads::johnson_row(mechanism.stations);
  const double diameter = 2. * mechanism.motion(mechanism.entry).pin_distance.value;
  return {diameter, given.dimensions.pin_diameter.value_or(row.k2 * diameter),
          given.dimensions.thickness.value_or(row.k3 * diameter)};
}

double analysed_angle(const MechanismCase& given, const loads::DrivenMechanism& driven,
                      const loads::WheelTrain& train) {
  switch (given.angle_kind) {
    case MechanismCase::AngleKind::at_maximum_wheel_acceleration:
      return loads::peak_acceleration_angle(driven);
    case MechanismCase::AngleKind::at_maximum_pin_force:
      return loads::peak_force_angle(driven, train);
    case MechanismCase::AngleKind::given:
      return given.driver_angle;
  }
  throw std::logic_error("unknown kind of driver angle");
}

std::vector<std::string> notices_of(const MechanismCase& given, const base::UnitSystem units) {
  std::vector<std::string> notices;
  const loads::GenevaDimensionsInput& sizes = given.dimensions;
  const bool has_proportions =
      sizes.pin_diameter && sizes.thickness && (sizes.locking_radius || !given.is_drawn());
  if (!loads::johnson_row(sizes.stations).from_table && !has_proportions)
    notices.push_back(fmt::format(
        "Johnson's Table 1 ends at 10 stations: the proportions that the case does not give are "
        "those of 10 stations scaled with sin(pi/n), n = {}",
        sizes.stations));
  if (given.kind == Kind::four_bar) {
    const auto length = base::output_unit(units, base::Dimension::length);
    const loads::FourBarGeneva found = four_bar(given);
    notices.push_back(fmt::format(
        "the wheel's axis is {:.6g} {} from the crank's; driver angle 0 is a crank angle of {:.6g} "
        "deg from the frame",
        found.centre_distance * length.factor, length.name,
        std::remainder(found.crank_angle, 2. * loads::pi) * 180. / loads::pi));
  }
  return notices;
}

}  // namespace geneva::model
