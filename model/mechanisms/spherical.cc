#include <cmath>

#include "loads/motion/spherical_geneva.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

class Spherical : public MechanismType {
 public:
  Spherical(const double shaft_angle, const double sphere_radius)
      : shaft_angle_(shaft_angle), sphere_radius_(sphere_radius) {}

  [[nodiscard]] loads::Mechanism mechanism(const Sizes& sizes) const override {
    return loads::spherical_geneva(sizes.stations, shaft_angle_, sphere_radius_);
  }
  [[nodiscard]] std::vector<std::pair<std::string, double>> lengths() const override {
    return {{"sphere radius", sphere_radius_}};
  }
  [[nodiscard]] std::optional<loads::Place> driver_axis() const override {
    return loads::Place{sphere_radius_ * std::sin(shaft_angle_), 0.,
                        sphere_radius_ * std::cos(shaft_angle_)};
  }

 private:
  double shaft_angle_;    ///< [rad]
  double sphere_radius_;  ///< [m]
};

}  // namespace

MechanismKind spherical_kind() {
  const SectionPath section{names::mechanism};
  const std::string only = " Only with Type = spherical.";
  MechanismKind kind;
  kind.name = "spherical";
  kind.help = "the shafts meet at an angle.";
  kind.sizes = {"Sphere radius"};
  kind.unused = lengths_of_drawings();
  kind.section = section;
  kind.parameters = {
      {section, "Shaft angle", "90 deg", positive(base::Dimension::angle),
       "Angle between the shafts of driver and wheel, between 0 and 180 deg." + only},
      {section, "Sphere radius", "", positive(base::Dimension::length, {""}),
       "Distance of the pin from the point where the shafts meet." + only}};
  kind.responsible = "Shaft angle";
  kind.read = [section](const CaseValues& values, const MechanismType::Sizes&) {
    return std::make_shared<Spherical>(values.value(section, "Shaft angle").value(),
                                       values.value(section, "Sphere radius").value());
  };
  return kind;
}

}  // namespace geneva::model
