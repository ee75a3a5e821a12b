#pragma once

#include <filesystem>
#include <variant>
#include <vector>

namespace geneva::app {

/// What the command line asks for.
struct Request {
  enum class Command {
    run,
    estimate,
    kinematics,
    design,
    design_with_strength,
    crown,
    synthesize,
    report,
    parameters
  };
  Command command;
  std::vector<std::filesystem::path> cases;  ///< one; for design one or more; of results for
                                             ///< report; for parameters none
  std::filesystem::path output;              ///< empty: results in the case's directory
  int steps = 720;                           ///< of the kinematic curves
  bool is_continued = false;                 ///< of run: from the checkpoint
  bool is_confirmed = true;                  ///< of crown: by finite elements
};

/// Reads the command line; prints help, version or what is wrong with it.
/// @return the request; the exit code if there is nothing more to do, 0 or 1
std::variant<Request, int> read_command_line(int argc, const char* const* argv);

}  // namespace geneva::app
