#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/motion/kinematics.h"
#include "post/output/limit_rows.h"

namespace geneva::post {

/// A figure of a roller beside that of a pin which is fixed to its carrier; SI units.
struct PinChoiceRow {
  std::string quantity;
  base::Dimension dimension;
  double roller;
  std::optional<double> fixed;  ///< none: it has no such figure
};

/// Kinematics and pin force of one case, SI units.
struct KinematicsReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string mechanism;   ///< in words
  bool is_roller;          ///< the pin; else it is fixed to its carrier
  double reference_speed;  ///< [rad/s]
  loads::Characteristics values;
  std::vector<loads::Unbounded> unbounded;
  std::vector<loads::KinematicsRow> rows;
  std::vector<PinChoiceRow> choice;  ///< of a roller
  std::vector<LimitRow> limits;      ///< by the closed forms
};

/// One line of the table of characteristic values; SI units.
struct CharacteristicRow {
  std::string quantity;
  std::string symbol;   ///< "φ″"; empty if there is none
  std::string meaning;  ///< a sentence's part
  base::Dimension dimension;
  double value;
  std::optional<double> driver_angle;  ///< at which it occurs [rad]
};
std::vector<CharacteristicRow> characteristic_rows(const loads::Characteristics& values,
                                                   double reference_speed);

/// "driving", "braking" or "none".
const char* name_of(loads::Wall wall);

/// What kinematics.json says, SI units throughout.
nlohmann::json kinematics_summary(const KinematicsReport& report);

/// What kinematics.csv says: the curves over the cycle, the units in the headings.
std::string kinematics_csv(const KinematicsReport& report, base::UnitSystem units);

/// Table of the characteristic values, the units in the rows' names.
std::string kinematics_table(const KinematicsReport& report, base::UnitSystem units);

}  // namespace geneva::post
