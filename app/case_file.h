#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "fem/problem.h"
#include "loads/engagement.h"
#include "loads/johnson.h"
#include "post/units.h"

namespace geneva::app {

/// A material as the case file gives it, SI units.
struct CaseMaterial {
  double youngs_modulus;
  double poissons_ratio;
  double density;
};

/// Model = mechanism: an external Geneva wheel and its pin.
struct MechanismCase {
  enum class AngleKind { at_maximum_wheel_acceleration, at_maximum_pin_force, given };
  enum class InertiaKind { from_geometry, johnson, given };

  loads::GenevaDimensionsInput dimensions;
  loads::DriverMotion motion;
  loads::WheelLoad load;
  AngleKind angle_kind;
  double driver_angle;  ///< [rad], if given
  InertiaKind inertia_kind;
  double wheel_inertia;  ///< [kg m^2], if given
  CaseMaterial pin;
  CaseMaterial wheel;
};

/// Model = geometry: the user's own plane geometry.
struct GeometryCase {
  std::filesystem::path file;  ///< .geo or .msh file in the case directory
  double length_unit;          ///< metres per unit of the file
  fem::Problem problem;
};

/// Everything that a case directory asks for, SI units.
struct Case {
  std::filesystem::path directory;
  std::string title;
  post::UnitSystem units;
  fem::Settings settings;
  std::optional<MechanismCase> mechanism;
  std::optional<GeometryCase> geometry;
  std::optional<double> published_peak_pressure;  ///< [Pa]
  std::string published_source;
  std::string completed;  ///< the case file with every default filled in
};

/// Reads case.prm of a case directory.
/// @throws std::invalid_argument naming file, parameter, the value found and what is allowed
Case read_case(const std::filesystem::path& directory);

/// Writes the whole commented parameter file, as `geneva parameters` prints it.
void print_parameters(std::ostream& out);

}  // namespace geneva::app
