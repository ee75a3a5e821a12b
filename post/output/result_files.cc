#include "post/output/result_files.h"

#include <algorithm>
#include <stdexcept>

namespace geneva::post {

namespace {

/// "solution.0.vtu" of "solution".
bool is_piece(const std::string& name, const std::string& of) {
  const std::string begin = of + ".";
  const std::string end = ".vtu";
  if (name.size() <= begin.size() + end.size()) return false;
  return name.rfind(begin, 0) == 0 && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

const std::vector<ResultFiles>& result_files() {
  static const std::vector<ResultFiles> files{
      {"summary",
       "geneva run",
       {"contact"},
       {"sections.csv", "depth.csv", "steps.csv", "contact.vtu", "solution.pvd", "solution.pvtu",
        "results.h5", "results.xdmf", "view.json", "stress.svg", "case.prm", "log.txt",
        "checkpoint.bin"},
       true},
      {"estimate", "geneva estimate", {"estimate"}, {}, true},
      {"kinematics", "geneva kinematics", {"kinematics"}, {}, true},
      {"design", "geneva design", {"design"}, {}, true},
      {"crown", "geneva design --crown", {"crown"}, {}, true},
      {"optimum", "geneva optimise", {}, {"optimum.csv", "optimum.prm"}, true},
      {"cycle",
       "geneva cycle",
       {},
       {"cycle.csv", "cycle_curve.csv", "cycle.pvd", "envelope.vtu", "cycle_view.json"},
       true},
      {"load_steps",
       "geneva cycle",
       {},
       {"load_steps.csv", "load_steps.pvd", "load_steps_envelope.vtu", "load_steps_view.json"},
       true},
      {"sweep", "geneva sweep", {}, {"sweep.csv"}, true},
      {"synthesis", "geneva synthesize", {"synthesis"}, {}, false}};
  return files;
}

bool is_shared_file(const std::string& name) {
  return name == "mechanism.json" || name == "report.html";
}

bool belongs_to(const ResultFiles& files, const std::string& name) {
  const auto is = [&](const char* other, const char* extension) {
    return name == std::string(other) + extension;
  };
  const bool is_table = std::any_of(files.tables.begin(), files.tables.end(),
                                    [&](const char* table) { return is(table, ".csv"); });
  const bool is_other = std::any_of(files.others.begin(), files.others.end(),
                                    [&](const char* other) { return is(other, ""); });
  const std::string document = files.document;
  const bool is_field = (document == "summary" && is_piece(name, "solution")) ||
                        (document == "cycle" && is_piece(name, "cycle")) ||
                        (document == "load_steps" && is_piece(name, "load_steps"));
  return is(files.document, ".json") || is_table || is_other || is_field;
}

std::filesystem::path own_file(const std::filesystem::path& directory, const std::string& name) {
  const std::vector<ResultFiles>& all = result_files();
  const bool is_own = std::any_of(
      all.begin(), all.end(), [&](const ResultFiles& files) { return belongs_to(files, name); });
  if (!is_own && !is_shared_file(name))
    throw std::logic_error(name + " is not in the list of the program's own files");
  return directory / name;
}

}  // namespace geneva::post
