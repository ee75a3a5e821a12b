#pragma once

#include <filesystem>

#include "model/input/case_file.h"
#include "post/output/kinematics_output.h"

namespace geneva::app {

/// Kinematics and pin force of a mechanism case over its cycle.
/// @param steps rows of the curves, 1 or more
/// @throws base::InputError if the case has no mechanism, or where the loads room does
post::KinematicsReport make_kinematics(const model::Case& given, int steps);

/// Does what `geneva kinematics` does: prints the characteristic values and writes kinematics.json
/// and kinematics.csv.
/// @param output where the files go; empty: results in the case's directory
/// @return the exit code, 0
int kinematics_of_case(const std::filesystem::path& case_directory,
                       const std::filesystem::path& output, int steps);

}  // namespace geneva::app
