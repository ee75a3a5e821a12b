#pragma once

#include <filesystem>
#include <vector>

namespace geneva::model {

/// Driver angles against time.
struct MotionTable {
  std::vector<double> times;   ///< [s]
  std::vector<double> angles;  ///< [rad]
};

/// Reads a comma-separated file: a heading "time [UNIT], angle [UNIT]" and a row of two numbers for
/// each instant; empty lines and lines that start with '#' are left out.
/// @throws base::InputError with file, line, what was found and what is wanted, if the heading
/// is another one, a unit is of another dimension or a row is not two numbers
MotionTable read_motion_table(const std::filesystem::path& file);

}  // namespace geneva::model
