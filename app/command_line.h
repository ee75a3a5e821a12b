#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace geneva::app {

/// What the command line asks for.
struct Request {
  enum class Command {
    run,
    cycle,
    estimate,
    kinematics,
    design,
    design_with_strength,
    crown,
    synthesize,
    report,
    sweep,
    optimise,
    export_drawings,
    surfaces,
    init,
    materials,
    parameters,
    help,
    version,
    manual,
    completion
  };
  Command command = Command::run;
  std::vector<std::filesystem::path> cases;  ///< one; for design one or more; of results for
                                             ///< report; of the new case for init; otherwise none
  std::filesystem::path output;              ///< empty: results in the case's directory
  int steps = 720;                           ///< of the kinematic curves
  bool is_continued = false;                 ///< of run: from the checkpoint
  bool is_confirmed = true;                  ///< of crown: by finite elements
  std::string topic;                    ///< of help and manual a command, of completion a shell,
                                        ///< of materials one of them; may be empty
  std::string type = "external";        ///< of init
  std::optional<int> stations;          ///< of init
  std::string units = "mm-N";           ///< of init
  std::vector<std::string> variations;  ///< of sweep: "Mechanism/Pin diameter = 8 mm; 10 mm"
  std::string method = "run";           ///< of sweep: the command for each combination
  std::string angle;                    ///< of export: of the driver; may be empty
  unsigned int jobs = 0;                ///< of sweep: runs at a time; 0: as many as cores
};

/// Reads the command line; prints help, version or what is wrong with it.
/// @return the request; the exit code if there is nothing more to do, 0 or 1
std::variant<Request, int> read_command_line(int argc, const char* const* argv);

}  // namespace geneva::app
