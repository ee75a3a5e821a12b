#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <string>

#include "api/version.h"

namespace geneva::app {

std::variant<Request, int> read_command_line(const int argc, const char* const* argv) {
  CLI::App app("Contact stress analysis of Geneva mechanisms", "geneva");
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  std::string case_directory;
  std::vector<std::string> case_directories;
  std::string output;
  auto* run = app.add_subcommand("run", "Solve a case and write its results");
  run->add_option("CASE_DIR", case_directory, "Directory with a case.prm")->required();
  run->add_option("-o,--output", output, "Where the results go (default: CASE_DIR/results)");
  bool is_continued = false;
  run->add_flag("--continue", is_continued,
                "Go on from the last mesh of an earlier run of this case, on any number of "
                "processes (see 'Checkpoint' of the case file)");
  int steps = Request{}.steps;
  auto* kinematics = app.add_subcommand(
      "kinematics", "Curves and characteristic values of a mechanism's motion and pin force");
  kinematics->add_option("CASE_DIR", case_directory, "Directory with a case.prm")->required();
  kinematics->add_option("-o,--output", output,
                         "Where kinematics.json and kinematics.csv go (default: CASE_DIR/results)");
  kinematics->add_option("--steps", steps, "Steps of the curves over the cycle (default: 720)")
      ->check(CLI::Range(1, 10000000));
  auto* estimate = app.add_subcommand(
      "estimate",
      "The contact without finite elements: pin force, Hertz, and along the pin in 3-D");
  estimate->add_option("CASE_DIR", case_directory, "Directory with a case.prm")->required();
  estimate->add_option("-o,--output", output,
                       "Where estimate.json and estimate.csv go (default: CASE_DIR/results)");
  auto* design = app.add_subcommand(
      "design", "Find the wheel of minimum contact stress and the vibration of the load (Johnson)");
  design->add_option("CASE_DIR", case_directories, "One or more directories with a case.prm")
      ->required();
  design->add_option("-o,--output", output,
                     "Where design.json, design.csv and the report go, with several cases into a "
                     "directory for each (default: CASE_DIR/results)");
  bool is_crown = false;
  design->add_flag("--crown", is_crown,
                   "Find instead the crown radius (or the amplitude of a logarithmic profile) by "
                   "which the line load along the pin of one case in 3-D is most even, and solve "
                   "that pin; writes crown.json, crown.csv and the report");
  bool has_strength = false;
  design->add_flag("--strength", has_strength,
                   "Also solve the wheel of one case by finite elements for several diameters: its "
                   "maximum stresses away from the contact, such as at the bottom of the slot, "
                   "beside the contact stress");
  bool is_unconfirmed = false;
  design->add_flag("--no-run", is_unconfirmed, "With --crown: do not solve the pin found");
  auto* synthesize = app.add_subcommand(
      "synthesize", "Find the dimensions of a quick-return, crank-rocker or path linkage");
  synthesize->add_option("CASE_DIR", case_directory, "Directory with a case.prm")->required();
  synthesize->add_option("-o,--output", output,
                         "Where synthesis.json and synthesis.csv go (default: CASE_DIR/results)");
  std::vector<std::string> results;
  auto* report = app.add_subcommand(
      "report", "Make report.html from a results directory again, or compare several");
  report->add_option("RESULTS_DIR", results, "One or more directories with results")->required();
  report->add_option("-o,--output", output,
                     "The HTML file to write (default: report.html in RESULTS_DIR, of several "
                     "directories comparison.html here)");
  const auto* parameters = app.add_subcommand(
      "parameters", "Print the whole parameter file with defaults and explanations");
  try {
    app.parse(argc, argv);
    if (is_crown && case_directories.size() > 1)
      throw CLI::ValidationError("--crown", "one CASE_DIR is wanted");
    if (has_strength && case_directories.size() > 1)
      throw CLI::ValidationError("--strength", "one CASE_DIR is wanted");
    if (has_strength && is_crown)
      throw CLI::ValidationError("--strength", "it designs the wheel, --crown the pin: give one");
    if (is_unconfirmed && !is_crown)
      throw CLI::ValidationError("--no-run", "this has an effect with --crown only");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  }
  if (parameters->parsed()) return Request{Request::Command::parameters, {}, {}, steps};
  if (run->parsed())
    return Request{Request::Command::run, {case_directory}, output, steps, is_continued};
  if (estimate->parsed())
    return Request{Request::Command::estimate, {case_directory}, output, steps};
  if (kinematics->parsed())
    return Request{Request::Command::kinematics, {case_directory}, output, steps};
  if (report->parsed())
    return Request{Request::Command::report, {results.begin(), results.end()}, output, steps};
  if (synthesize->parsed())
    return Request{Request::Command::synthesize, {case_directory}, output, steps};
  return Request{is_crown       ? Request::Command::crown
                 : has_strength ? Request::Command::design_with_strength
                                : Request::Command::design,
                 {case_directories.begin(), case_directories.end()},
                 output,
                 steps,
                 false,
                 !is_unconfirmed};
}

}  // namespace geneva::app
