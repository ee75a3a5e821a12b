#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/pin/load_evenness.h"
#include "loads/pin/profile_search.h"

namespace geneva::post {

/// What `geneva design --crown` finds.
struct CrownReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string parameter;                    ///< "Crown radius" or "Profile amplitude"
  std::string profile;                      ///< "crown" or "logarithmic"
  double size;                              ///< found [m]
  double drop;                              ///< of the profile at the wheel's faces [m]
  double force;                             ///< for which it was searched [N]
  std::vector<double> tilts;                ///< between which the pin may lean, one or two [rad]
  double worst_tilt;                        ///< of the profile found [rad]
  std::vector<loads::ProfileTrial> trials;  ///< in their order
  loads::ProfileMap map;                    ///< around the profile found
  loads::LoadEvenness before;               ///< the case's profile, at its worst tilt
  loads::LoadEvenness after;                ///< the one found, at its worst tilt
  std::optional<loads::LoadEvenness> confirmed;  ///< the same by finite elements
};

/// What crown.json says, SI units throughout.
nlohmann::json crown_summary(const CrownReport& report);

/// What crown.csv says: line load and maximum pressure of each section of all pins, in output
/// units, the units in the heading.
std::string crown_csv(const CrownReport& report, base::UnitSystem units);

/// Table of the pin before and after, by finite elements if they were asked, the units in the rows'
/// names, and the lines for the case.
std::string crown_table(const CrownReport& report, base::UnitSystem units);

}  // namespace geneva::post
