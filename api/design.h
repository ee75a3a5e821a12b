#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/written.h"
#include "post/output/design_output.h"

namespace geneva {

/// Johnson's wheel of minimum contact stress for a mechanism, and the shaft.
struct Design {
  Case given;
  post::DesignReport report;
  std::vector<std::string> notices;  ///< what the user should know of the figures
};

/// Johnson's design of wheel and shaft for the mechanism of a case (Johnson 1956, Eq. 1 to 16).
/// @throws InputError if the case is no mechanism or has no best wheel
Design design(const Case& given);

/// The mechanism as the design looks at it: at the maximum wheel acceleration, with the shaft's
/// inertia where it is to be added.
/// @throws InputError where design() does
model::MechanismCase designed_mechanism(const Case& given);

/// Designs side by side as `geneva design` prints them, in the units of the first.
std::string table(const std::vector<Design>& designs);

/// Writes design.json, design.csv, mechanism.json and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Design& design, const std::filesystem::path& directory);

}  // namespace geneva
