#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/written.h"
#include "post/output/estimate_output.h"

namespace geneva {

/// A mechanism's contact without finite elements.
struct Estimate {
  Case given;
  post::EstimateReport report;
  std::vector<std::string> notices;  ///< what the user should know of the mechanism
};

/// Pin force, Hertz's contact and, in 3-D, line contacts along the pin that half-spaces and a beam
/// couple (loads/pin/pin_line.h).
/// @throws InputError if the case has no mechanism, or one that cannot move, or none whose pin
/// presses on the driving wall
Estimate estimate(const Case& given);

/// The figures as `geneva estimate` prints them, in the case's units.
std::string table(const Estimate& estimate);

/// Writes estimate.json, estimate.csv, mechanism.json and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Estimate& estimate, const std::filesystem::path& directory);

}  // namespace geneva
