#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::model {

/// Factors of loads at one instant after the other.
struct LoadSteps {
  std::vector<double> times;                 ///< [s], increasing
  std::vector<std::string> loads;            ///< "top", or a component of it, "top x"
  std::vector<std::vector<double>> factors;  ///< by step, as `loads`; at least one step
};

/// Reads a comma-separated file: a heading "time [s], LOAD, LOAD", with any unit of time, and a row
/// of numbers for each step; empty lines and lines that start with '#' are left out.
/// @throws base::InputError with file, line, what was found and what is wanted, if the heading is
/// another one, a row is not as many finite numbers, times do not increase or there is no row
LoadSteps read_load_steps(const std::filesystem::path& file);

}  // namespace geneva::model
