#include "model/input/geometry_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "base/units.h"
#include "mesh/file_kind.h"
#include "model/input/case_path.h"

namespace geneva::model {

namespace {

namespace fs = std::filesystem;

/// Of lengths that are read from a STEP file, whatever its own is [m].
constexpr double step_unit = 1e-3;
constexpr const char* surface_word = "Surface ";
constexpr const char* solid_word = "Solid ";

bool begins_with(const std::string& text, const std::string& word) {
  return text.size() > word.size() && text.compare(0, word.size(), word) == 0;
}

std::string without(const std::string& text, const std::string& word) {
  return begins_with(text, word) ? trimmed(text.substr(word.size())) : text;
}

/// A length; 0 needs no unit.
std::optional<double> length_of(const std::string& text) {
  if (text == "0") return 0.;
  try {
    return base::parse_quantity(text, base::Dimension::length);
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

mesh::Pick read_pick(const CaseValues& values, const std::string& parameter, const bool is_body,
                     const int dimension) {
  const SectionPath section{names::geometry};
  const char* const kind =
      dimension == 3 ? (is_body ? "solid " : "face ") : (is_body ? "face " : "edge ");
  const std::string text = without(values.text(section, parameter), kind);
  const std::vector<std::string> parts = split_list(without(text, "nearest "));
  const auto refuse = [&](const std::string& found) {
    values.refuse(section, parameter,
                  fmt::format("{}'{}nearest {}' is wanted, lengths with their units", found, kind,
                              dimension == 3 ? "12 mm, 0, 3 mm" : "12 mm, 0"));
  };
  if (!begins_with(text, "nearest ")) refuse("");
  if (parts.size() != static_cast<std::size_t>(dimension))
    refuse(fmt::format("it has {} numbers in place of {}: ", parts.size(), dimension));
  mesh::Pick pick{trimmed(parameter.substr(parameter.find(' '))), is_body, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<double> length = length_of(parts[i]);
    if (!length) refuse(fmt::format("{} is no length: ", base::in_quotes(parts[i])));
    pick.place[i] = *length;
  }
  return pick;
}

std::vector<mesh::Pick> read_picks(const CaseValues& values, const int dimension) {
  std::vector<mesh::Pick> picks;
  for (const bool is_body : {false, true})
    for (const std::string& name :
         values.names({names::geometry}, is_body ? solid_word : surface_word))
      picks.push_back(read_pick(values, name, is_body, dimension));
  return picks;
}

fs::path read_file_name(const CaseSection& section, const fs::path& directory) {
  const fs::path name = section.text("File");
  const std::string kind = name.extension().string();
  if (kind != ".geo" && kind != ".msh" && kind != ".step" && kind != ".stp")
    section.refuse("File",
                   "the name of a .geo, .msh, .step or .stp file in the case directory is wanted");
  return file_in_directory(section, "File", directory);
}

double read_length_unit(const CaseSection& section) {
  const std::string unit = section.text("Length unit");
  const bool has_number = unit.find_first_of("0123456789.+-") == 0;
  QuantityRule rule;
  rule.dimension = base::Dimension::length;
  rule.range = greater_than_zero();
  try {
    return model::values(rule, has_number ? unit : "1 " + unit).front();
  } catch (const std::invalid_argument&) {
    section.refuse("Length unit", "a unit of length is wanted, for example 'mm', 'in' or '0.1 mm'");
  }
}

}  // namespace

std::vector<std::string> pick_names(const ParameterText& text) {
  std::vector<std::string> result;
  for (const Assignment& found : text.assignments)
    if (found.section == SectionPath{names::geometry} &&
        (begins_with(found.name, surface_word) || begins_with(found.name, solid_word)))
      result.push_back(found.name);
  return result;
}

std::string default_geometry_file(const ParameterText& text, const fs::path& directory) {
  std::error_code error;
  const bool has_geo = fs::exists(directory / "geometry.geo", error);
  const bool has_msh = fs::exists(directory / "geometry.msh", error);
  if (has_geo == has_msh)
    throw base::InputError(fmt::format(
        "{}: the case directory has {} 'geometry.geo' {} 'geometry.msh'; {} in the subsection "
        "'Geometry' names the file",
        text.file, has_geo ? "both" : "neither", has_geo ? "and" : "nor", "'set File = ...'"));
  return has_geo ? "geometry.geo" : "geometry.msh";
}

GeometryFile read_geometry_file(const CaseValues& values, const fs::path& directory,
                                const int dimension) {
  const CaseSection section(values, {names::geometry});
  GeometryFile result;
  result.file = read_file_name(section, directory);
  result.circle_tolerance = section.value("Circle tolerance");
  result.picks = read_picks(values, dimension);
  result.cell_size = section.optional_value("Cell size");
  const bool is_step = mesh::kind_of(result.file) == mesh::FileKind::step;
  if (is_step && section.is_changed("Length unit"))
    section.refuse("Length unit", "a STEP file has its own unit: delete it");
  if (!is_step && section.is_given("Cell size"))
    section.refuse("Cell size", "this has an effect with a STEP file only: delete it");
  if (!is_step && !result.picks.empty())
    values.refuse_section(
        {names::geometry},
        "'Surface NAME' and 'Solid NAME' name places of a STEP file; in a .geo or "
        ".msh file physical groups have names");
  result.length_unit = is_step ? step_unit : read_length_unit(section);
  return result;
}

GeometryFile read_geometry_file(const ParameterText& text, const fs::path& directory,
                                const int dimension) {
  const Assignment* file = text.find({names::geometry}, "File");
  const std::vector<Parameter> parameters = geometry_file_parameters(
      pick_names(text), file == nullptr ? default_geometry_file(text, directory) : file->value);
  ParameterText own = text;
  own.sections = {};
  own.assignments.clear();
  for (const Assignment& found : text.assignments)
    if (std::any_of(parameters.begin(), parameters.end(), [&](const Parameter& parameter) {
          return parameter.section == found.section && parameter.name == found.name;
        }))
      own.assignments.push_back(found);
  return read_geometry_file(CaseValues(parameters, own), directory, dimension);
}

}  // namespace geneva::model
