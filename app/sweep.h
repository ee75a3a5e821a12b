#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::app {

/// What `geneva sweep` is asked for.
struct SweepRequest {
  std::vector<std::string> variations;
  std::string command;           ///< "run", "estimate", "kinematics" or "design"
  unsigned int jobs;             ///< runs at a time; 0: as many as cores
  std::filesystem::path output;  ///< empty: sweep in the case's directory
};

/// `geneva sweep`: does a command for every combination of values, prints a line for each and a
/// table, and writes the results. Runs are processes of their own, each in the directory of its
/// point; one that fails is told and ends no other; one that ended earlier with the same case is
/// not done again.
/// @return exit code: 0, or 2 if a point failed or is not as accurate as asked
/// @throws base::InputError if a variation is wrong, or no point can be done
int sweep_case(const std::filesystem::path& case_directory, const SweepRequest& request);

}  // namespace geneva::app
