#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/design/design.h"
#include "loads/design/shaft.h"
#include "loads/motion/pin_load.h"

namespace geneva::post {

/// The load's vibration on its shaft.
struct ShaftReport {
  loads::TorsionalVibration vibration;
  double inertia;                          ///< of the shaft itself [kg m^2]
  bool is_inertia_added;                   ///< to the load's, outside of the vibration
  std::optional<double> amplitude_radius;  ///< [m]
};

/// The wheel of one diameter, solved by finite elements; SI units.
struct WheelStrength {
  double diameter;             ///< [m]
  double peak_pressure;        ///< of the contact, by finite elements [Pa]
  double peak_pressure_error;  ///< relative
  double von_mises;            ///< maximum of the wheel away from the contact [Pa]
  double von_mises_error;      ///< relative
  double tensile;              ///< maximum of the wheel away from the contact [Pa]
  double tensile_error;        ///< relative
  std::string where;           ///< the tensile stress, in words
};

/// Johnson's design of wheel and shaft for one case, SI units.
struct DesignReport {
  base::CaseHeader about;
  std::string geneva_version;
  loads::JohnsonRow row;
  loads::WheelLoad load;     ///< with the shaft's inertia where it is added
  double peak_acceleration;  ///< of the wheel, at -beta [rad/s^2]
  double exit_acceleration;  ///< a_v, deceleration of the wheel as the pin leaves [rad/s^2]
  loads::WorkingCycle cycle;
  loads::GivenLengths given_lengths;
  std::optional<loads::DesignedWheel> johnson;  ///< optimum with Table 1; none beyond 10 stations
  loads::DrawnOptimum drawn;                    ///< optimum with the case's own proportions
  loads::DesignedWheel own;                     ///< the wheel that the case describes
  bool has_johnsons_inertia;                    ///< own, by his k5; else as drawn or given
  std::optional<double> pressure_ratio;         ///< own peak pressure over that of johnson
  std::optional<ShaftReport> shaft;
  std::vector<loads::DesignPoint> curve;
  std::vector<WheelStrength> strength;  ///< by ascending diameter; empty unless asked for
};

/// What design.json says, SI units throughout.
nlohmann::json design_summary(const DesignReport& report);

/// What design.csv says: inertia, pin force and stress against the diameter, the units in the
/// headings; empty fields where there is no such wheel.
std::string design_csv(const DesignReport& report, base::UnitSystem units);

/// Stresses of the wheel away from the contact against its diameter, the unit in the headings.
std::string strength_table(const DesignReport& report, base::UnitSystem units);

/// Table of one or more designs side by side, the units in the rows' names.
std::string design_table(const std::vector<DesignReport>& reports, base::UnitSystem units);

}  // namespace geneva::post
