#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/written.h"
#include "post/output/kinematics_output.h"

namespace geneva {

/// Motion and pin force of a mechanism over its cycle.
struct Kinematics {
  Case given;
  post::KinematicsReport report;
  std::vector<std::string> notices;  ///< what the user should know of the motion
};

/// Kinematics and pin force of a mechanism case over its cycle.
/// @param steps rows of the curves, 1 or more
/// @throws InputError if the case has no mechanism, or one that cannot move
Kinematics kinematics(const Case& given, int steps = 720);

/// The characteristic values as `geneva kinematics` prints them, in the case's units.
std::string table(const Kinematics& kinematics);

/// Writes kinematics.json, kinematics.csv, mechanism.json and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Kinematics& kinematics, const std::filesystem::path& directory);

}  // namespace geneva
