#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "post/analysis/load_evenness.h"

namespace geneva::post {

/// One step of the search for the most even line load.
struct CrownTrial {
  double size;   ///< crown radius, or amplitude of the logarithmic profile [m]
  double ratio;  ///< maximum over even line load
  bool is_scan;  ///< on coarse meshes, before the search on finer ones
};

/// What `geneva design --crown` finds.
struct CrownReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string parameter;           ///< "Crown radius" or "Profile amplitude"
  std::string profile;             ///< "crown" or "logarithmic"
  double size;                     ///< found [m]
  double drop;                     ///< of the profile at the wheel's faces [m]
  std::vector<CrownTrial> trials;  ///< in their order
  LoadEvenness before;             ///< the case as it is
  LoadEvenness after;
};

/// What crown.json says, SI units throughout.
nlohmann::json crown_summary(const CrownReport& report);

/// What crown.csv says: line load and maximum pressure of each section of both pins, in output
/// units, the units in the heading.
std::string crown_csv(const CrownReport& report, base::UnitSystem units);

/// Table of the pin before and after, the units in the rows' names, and the lines for the case.
std::string crown_table(const CrownReport& report, base::UnitSystem units);

}  // namespace geneva::post
