#include "model/mechanism_motion.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace geneva::model {

namespace {

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
      return loads::law_on_cross(mechanism, given.type->plane().value(),
                                 centre_distance(given.dimensions), engagements, motion.law,
                                 motion.motion_time);
  }
  throw std::logic_error("unknown kind of driver motion");
}

}  // namespace

loads::Mechanism mechanism_of(const MechanismCase& given) {
  return given.type->mechanism(given.dimensions);
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
  return loads::mechanism_sizes(mechanism_of(given), given.dimensions.pin_diameter,
                                given.dimensions.thickness);
}

double stud_core_radius(const MechanismCase& mechanism) {
  const double stud = mechanism.roller->diameter - *mechanism.bore_clearance;
  return mechanism.dimensions.pin_core_radius.value_or(stud / 4.);
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
      sizes.pin_diameter && sizes.thickness && (sizes.locking_radius || !given.type->is_drawn());
  if (!loads::johnson_row(sizes.stations).from_table && !has_proportions)
    notices.push_back(fmt::format(
        "Johnson's Table 1 ends at 10 stations: the proportions that the case does not give are "
        "those of 10 stations scaled with sin(pi/n), n = {}",
        sizes.stations));
  for (std::string& notice : given.type->notices(sizes, units))
    notices.push_back(std::move(notice));
  return notices;
}

}  // namespace geneva::model
