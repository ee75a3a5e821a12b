#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// How evenly a pin carries its load along its length. The greatest line load is the greatest mean
/// over a twentieth of the length: at a sharp edge the line load itself has no bound.
struct LoadEvenness {
  double greatest;       ///< [N/m]
  double place;          ///< middle of that twentieth along z [m]
  double even;           ///< pin force over the length on which the surfaces face each other [N/m]
  double peak_pressure;  ///< [Pa]
  double middle_pressure;                ///< [Pa]
  bool is_bounded;                       ///< the pressure at the ends
  std::vector<ContactSection> sections;  ///< by ascending z

  /// 1 for an even load.
  [[nodiscard]] double ratio() const { return greatest / even; }
};

/// Greatest mean line load over a length.
struct GreatestMean {
  double value;  ///< [N/m]
  double place;  ///< middle of that length along z [m]
};

/// @param sections by ascending z; beyond them there is no load
/// @param length [m], > 0
GreatestMean greatest_mean_load(const std::vector<ContactSection>& sections, double length);

/// @throws base::InputError if the leading contact carries nothing
LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results);

/// One step of the search for the most even line load.
struct CrownTrial {
  double size;   ///< crown radius, or amplitude of the logarithmic profile [m]
  double ratio;  ///< greatest over even line load
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

/// What crown.csv says: line load and greatest pressure of each section of both pins, in output
/// units, the units in the heading.
std::string crown_csv(const CrownReport& report, base::UnitSystem units);

/// Table of the pin before and after, the units in the rows' names, and the lines for the case.
std::string crown_table(const CrownReport& report, base::UnitSystem units);

}  // namespace geneva::post
