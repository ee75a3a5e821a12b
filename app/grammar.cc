#include "app/grammar.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <vector>

#include "api/version.h"
#include "model/input/nearest_word.h"

namespace geneva::app {

namespace {

using Command = Request::Command;

constexpr const char* examples =
    "Examples:\n"
    "  geneva init --type external --stations 6 wheel   a commented case to start from\n"
    "  geneva run wheel                                 solve it: wheel/results/report.html\n"
    "  geneva kinematics wheel                          motion, forces and pressure over the "
    "cycle\n"
    "'geneva help COMMAND' tells more of one.";

/// Looks at an option's text before it is made a number.
CLI::Validator whole_number(const int least, const int most) {
  return CLI::Validator(
      [least, most](const std::string& text) {
        int value = 0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, value);
        const bool is_whole = error == std::errc() && rest == end;
        if (is_whole && value >= least && value <= most) return std::string();
        return fmt::format("'{}': a whole number from {} to {} is wanted", text, least, most);
      },
      "");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::Validator(
      [words](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
        const auto nearest = model::nearest_word(text, words);
        return fmt::format("'{}': one of {} is wanted{}", text, fmt::join(words, ", "),
                           nearest ? fmt::format("; did you mean '{}'?", *nearest) : "");
      },
      "");
}

CLI::Option* add_case(CLI::App* command, std::string& directory) {
  return command->add_option("CASE_DIR", directory,
                             "Directory with a case.prm (default: the current one)");
}

/// @param what goes there
void add_output(CLI::App* command, std::string& output, const std::string& what,
                const std::string& kind = "DIR") {
  command->add_option("-o,--output", output, what)->type_name(kind);
}

}  // namespace

Grammar::Grammar() : app_("Contact stress analysis of Geneva mechanisms", "geneva") {
  app_.set_version_flag("--version", version);
  app_.set_help_flag("-h,--help", "Print this help");
  app_.footer(examples);
  app_.require_subcommand(0, 1);
  add_analyses();
  add_design();
  add_documents();
  add_helpers();
}

CLI::App* Grammar::add(const Command command, const std::string& name, const std::string& help) {
  CLI::App* added = app_.add_subcommand(name, help);
  added->set_help_flag("-h,--help", "Print this help");
  added->footer("");
  commands_.emplace_back(added, command);
  return added;
}

void Grammar::add_analyses() {
  CLI::App* init = add(Command::init, "init", "Write a commented case that runs at once");
  init->add_option("DIR", case_directory_, "Where it goes (default: the current directory)");
  init->add_option("--type", request_.type,
                   "external, internal, spherical, long-dwell, four-bar, or geometry for a drawing "
                   "of one's own (default: external)")
      ->type_name("TYPE");
  init->add_option("--stations", request_.stations, "Of the wheel (default: 6)")
      ->type_name("NUMBER")
      ->check(whole_number(3, 24));
  init->add_option("--units", request_.units, "SI, mm-N or in-lbf (default: mm-N)")
      ->type_name("SYSTEM");
  CLI::App* run = add(Command::run, "run", "Solve a case and write its results");
  add_case(run, case_directory_);
  add_output(run, output_, "Where the results go (default: CASE_DIR/results)");
  run->add_flag("--continue", request_.is_continued,
                "Go on from the last mesh of an earlier run of this case, on any number of "
                "processes (see 'Checkpoint' of the case file)");
  CLI::App* cycle =
      add(Command::cycle, "cycle",
          "Solve the contact over the whole engagement, on both walls: pressure, stresses, torque "
          "and friction at every instant that counts ('Instants' of the case); of a geometry, at "
          "its 'Load steps'");
  add_case(cycle, case_directory_);
  add_output(
      cycle, output_,
      "Where cycle.json (of a geometry load_steps.json), its table and the report go (default: "
      "CASE_DIR/results)");
  CLI::App* kinematics =
      add(Command::kinematics, "kinematics",
          "Curves and characteristic values of a mechanism's motion and pin force");
  add_case(kinematics, case_directory_);
  add_output(kinematics, output_,
             "Where kinematics.json and kinematics.csv go (default: CASE_DIR/results)");
  kinematics
      ->add_option("--steps", request_.steps, "Steps of the curves over the cycle (default: 720)")
      ->type_name("NUMBER")
      ->check(whole_number(1, 10000000));
  CLI::App* drawings =
      add(Command::export_drawings, "export",
          "Write wheel, driver with locking disc, pin and assembly for CAD systems (STEP and DXF)");
  add_case(drawings, case_directory_);
  add_output(drawings, output_, "Where the files go (default: CASE_DIR/cad)");
  drawings
      ->add_option("--angle", request_.angle,
                   "Driver angle of the assembly, as '20 deg', 0 midway through the engagement "
                   "(default: the one that the case is analysed at)")
      ->type_name("ANGLE");
  CLI::App* surfaces =
      add(Command::surfaces, "surfaces",
          "List and draw the bodies and surfaces of a case's geometry file that can be named, with "
          "their places; of the case only what concerns the file needs to be there, and for a STEP "
          "file in its place nothing");
  add_case(surfaces, case_directory_);
  add_output(surfaces, output_,
             "The HTML file with the pictures (default: surfaces.html in CASE_DIR)", "FILE");
  CLI::App* estimate =
      add(Command::estimate, "estimate",
          "The contact without finite elements: pin force, Hertz, and along the pin in 3-D");
  add_case(estimate, case_directory_);
  add_output(estimate, output_,
             "Where estimate.json and estimate.csv go (default: CASE_DIR/results)");
}

void Grammar::add_design() {
  CLI::App* design =
      add(Command::design, "design",
          "Find the wheel of minimum contact stress and the vibration of the load (Johnson)");
  design->add_option("CASE_DIR", several_,
                     "One or more directories with a case.prm (default: the current one)");
  add_output(design, output_,
             "Where design.json, design.csv and the report go, with several cases into a "
             "directory for each (default: CASE_DIR/results)");
  design->add_flag("--crown", is_crown_,
                   "Find instead the crown radius (or the amplitude of a logarithmic profile) by "
                   "which the line load along the pin of one case in 3-D is most even, and solve "
                   "that pin; writes crown.json, crown.csv and the report");
  design->add_flag("--strength", has_strength_,
                   "Also solve the wheel of one case by finite elements for several diameters: its "
                   "maximum stresses away from the contact, such as at the bottom of the slot, "
                   "beside the contact stress");
  design->add_flag("--no-run", is_unconfirmed_, "With --crown: do not solve the pin found");
  CLI::App* optimise = add(
      Command::optimise, "optimise",
      "Find the dimensions that make the contact pressure, the mass or the stress at the slot's "
      "bottom least, under limits (subsection 'Optimisation' of the case)");
  add_case(optimise, case_directory_);
  add_output(optimise, output_,
             "Where optimum.json, optimum.csv, optimum.prm and the report go (default: "
             "CASE_DIR/results)");
  CLI::App* sweep = add(Command::sweep, "sweep",
                        "Vary parameters of a case: every combination, in parallel, as table and "
                        "curves; runs that are done already are kept");
  add_case(sweep, case_directory_);
  sweep
      ->add_option(
          "--set", request_.variations,
          "'Mechanism/Pin diameter = 8 mm .. 14 mm, 7': seven values from first to last "
          "(', log': by equal ratios); 'Mechanism/Pin/Held at = one end; both ends': these")
      ->required()
      ->expected(1)
      ->take_all()
      ->type_name("VARIATION");
  sweep
      ->add_option("--with", request_.method,
                   "What is done for each: run, estimate, kinematics or design (default: run)")
      ->type_name("COMMAND")
      ->check(one_of({"run", "estimate", "kinematics", "design"}));
  sweep->add_option("-j,--jobs", request_.jobs, "Runs at a time (default: as many as cores)")
      ->type_name("NUMBER")
      ->check(whole_number(1, 1000));
  add_output(sweep, output_,
             "Where sweep.json, sweep.csv, the report and the points go (default: "
             "CASE_DIR/sweep)");
  CLI::App* synthesize = add(Command::synthesize, "synthesize",
                             "Find the dimensions of a quick-return, crank-rocker or path linkage");
  add_case(synthesize, case_directory_);
  add_output(synthesize, output_,
             "Where synthesis.json and synthesis.csv go (default: CASE_DIR/results)");
}

void Grammar::add_documents() {
  CLI::App* report = add(Command::report, "report",
                         "Make report.html from a results directory again, or compare several");
  report->add_option("RESULTS_DIR", several_, "One or more directories with results")->required();
  add_output(report, output_,
             "The HTML file to write (default: report.html in RESULTS_DIR, of several "
             "directories comparison.html here)",
             "FILE");
  CLI::App* materials = add(Command::materials, "materials",
                            "List the materials that a case may name, or all that is known of one");
  materials->add_option("NAME", request_.topic, "A material of the list")->type_name("");
  materials
      ->add_option("--case", case_directory_,
                   "With the materials.prm of this case directory (default: the current one)")
      ->type_name("DIR");
  add(Command::parameters, "parameters",
      "Print the whole parameter file with defaults and explanations");
}

void Grammar::add_helpers() {
  CLI::App* help = add(Command::help, "help", "Print what a command does and takes");
  help->add_option("COMMAND", request_.topic, "One of the commands");
  add(Command::version, "version", "Print the version");
  CLI::App* manual = add(Command::manual, "man", "Print the manual page of a command");
  manual->add_option("COMMAND", request_.topic, "One of the commands; none: of the program");
  CLI::App* complete =
      add(Command::completion, "completion", "Print the completion of commands for a shell");
  complete->add_option("SHELL", request_.topic, "bash, zsh or fish")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
}

Request Grammar::request() const {
  Request request = request_;
  for (const auto& [subcommand, command] : commands_)
    if (subcommand->parsed()) request.command = command;
  request.output = output_;
  request.cases = {case_directory_};
  if (request.command == Command::design || request.command == Command::report)
    request.cases.assign(several_.begin(), several_.end());
  if (request.cases.empty()) request.cases = {"."};
  if (request.command != Command::design) return request;
  if (is_crown_ && request.cases.size() > 1)
    throw CLI::ValidationError("--crown", "one CASE_DIR is wanted");
  if (has_strength_ && request.cases.size() > 1)
    throw CLI::ValidationError("--strength", "one CASE_DIR is wanted");
  if (has_strength_ && is_crown_)
    throw CLI::ValidationError("--strength", "it designs the wheel, --crown the pin: give one");
  if (is_unconfirmed_ && !is_crown_)
    throw CLI::ValidationError("--no-run", "this has an effect with --crown only");
  request.is_confirmed = !is_unconfirmed_;
  if (is_crown_) request.command = Command::crown;
  if (has_strength_) request.command = Command::design_with_strength;
  return request;
}

CLI::App* command_named(CLI::App& app, const std::string& name) {
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    if (command->get_name() == name) return command;
  return nullptr;
}

}  // namespace geneva::app
