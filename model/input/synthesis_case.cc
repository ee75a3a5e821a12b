#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "model/input/case_models.h"
#include "model/input/case_path.h"
#include "model/input/column_file.h"

namespace geneva::model {

namespace {

namespace fs = std::filesystem;
using loads::PathDimension;

constexpr std::size_t most_points = 9;
constexpr double maximum_coordinate = 1e6;  // [m]

constexpr std::array<std::pair<const char*, PathDimension>, 9> path_dimensions{
    {{"Crank pivot x", PathDimension::crank_pivot_x},
     {"Crank pivot y", PathDimension::crank_pivot_y},
     {"Rocker pivot x", PathDimension::rocker_pivot_x},
     {"Rocker pivot y", PathDimension::rocker_pivot_y},
     {"Crank", PathDimension::crank},
     {"Coupler", PathDimension::coupler},
     {"Rocker", PathDimension::rocker},
     {"Coupler point distance", PathDimension::point_distance},
     {"Coupler point angle", PathDimension::point_angle}}};

/// Kinds in which a parameter of the subsection has an effect.
std::vector<std::string> kinds_of(const std::string& name) {
  if (name == "Crank") return {names::quick_return, names::path};
  if (name == "Rocker") return {names::crank_rocker, names::path};
  for (const char* known : {"Stations", "Maximum wheel speed", "Frame"})
    if (name == known) return {names::quick_return};
  for (const char* known : {"Swing", "Crank pivot distance"})
    if (name == known) return {names::crank_rocker};
  return {names::path};
}

void check_kind(const CaseSection& section, const std::string& kind) {
  for (const Parameter& parameter : synthesis_parameters()) {
    const std::string& name = parameter.name;
    if (name == "Kind" || section.text(name) == parameter.default_value) continue;
    const std::vector<std::string> kinds = kinds_of(name);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      section.refuse(name, fmt::format("this has an effect with Kind = {} only, but this case has "
                                       "Kind = {}",
                                       fmt::join(kinds, " or "), kind));
  }
}

/// A value that the kind of synthesis cannot do without.
double needed(const CaseSection& section, const char* name) {
  if (!section.is_given(name))
    section.refuse_missing(name, fmt::format("'Kind' = '{}' needs it", section.text("Kind")));
  return section.value(name);
}

loads::QuickReturnInput read_quick_return(const CaseSection& section) {
  loads::QuickReturnInput input{static_cast<int>(needed(section, "Stations")),
                                needed(section, "Maximum wheel speed"),
                                section.optional_value("Crank"), section.optional_value("Frame")};
  if (input.crank && input.centre_distance)
    section.refuse("Crank",
                   "'Frame' is given already, and the stations fix one by the other: give "
                   "one of the two");
  if (!input.crank && !input.centre_distance)
    section.refuse_missing("Frame", "'Frame' or 'Crank' gives the size of the mechanism");
  return input;
}

loads::CrankRockerInput read_crank_rocker(const CaseSection& section) {
  return {needed(section, "Swing"), needed(section, "Rocker"),
          needed(section, "Crank pivot distance")};
}

std::vector<std::array<double, 2>> read_points(const fs::path& file) {
  const auto columns = read_two_columns(
      file, {{{"x", base::Dimension::length}, {"y", base::Dimension::length}}}, "x [mm], y [mm]");
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (std::max(std::abs(columns[0][i]), std::abs(columns[1][i])) > maximum_coordinate)
      throw base::InputError(fmt::format(
          "{}: point {} is ({:.3g}, {:.3g}) m: a coordinate must be from -1000 to 1000 km",
          file.string(), i + 1, columns[0][i], columns[1][i]));
    points.push_back({columns[0][i], columns[1][i]});
  }
  if (points.size() < 2 || points.size() > most_points)
    throw base::InputError(fmt::format(
        "{}: number of points is {}: a four-bar linkage can be made to pass 2 to {}; write a "
        "heading 'x [mm], y [mm]' and that many rows",
        file.string(), points.size(), most_points));
  return points;
}

std::vector<std::string> names_of_dimensions(const CaseSection& section, const bool is_given) {
  std::vector<std::string> found;
  for (const auto& [name, dimension] : path_dimensions)
    if (section.is_given(name) == is_given) found.emplace_back(name);
  return found;
}

/// As many dimensions are given as the points leave open.
void check_given(const CaseSection& section, const std::size_t points) {
  const std::size_t wanted = most_points - points;
  const std::vector<std::string> given = names_of_dimensions(section, true);
  if (given.size() == wanted) return;
  const std::string found = given.empty() ? "none is given" : "given are " + listed(given);
  const std::string advice = given.size() > wanted
                                 ? fmt::format("leave out {}", given.size() - wanted)
                                 : fmt::format("give {} more of {}", wanted - given.size(),
                                               listed(names_of_dimensions(section, false)));
  section.refuse(fmt::format("with {} points {} of the nine dimensions are to be given, but {}; {}",
                             points, wanted == 0 ? "none" : fmt::format("exactly {}", wanted),
                             found, advice));
}

PathCase read_path(const CaseSection& section, const fs::path& directory) {
  PathCase result{file_in_directory(section, "Points", directory), {}};
  result.task.points = read_points(result.file);
  check_given(section, result.task.points.size());
  for (const auto& [name, dimension] : path_dimensions)
    if (const auto value = section.optional_value(name))
      result.task.given.push_back({dimension, *value});
  result.task.starts = static_cast<int>(section.value("Starts"));
  result.task.seed = static_cast<std::uint64_t>(section.value("Seed"));
  return result;
}

}  // namespace

SynthesisCase read_synthesis(const CaseValues& values, const fs::path& directory) {
  const CaseSection section(values, {names::synthesis});
  const std::string kind = section.text("Kind");
  check_kind(section, kind);
  if (kind == names::quick_return) return read_quick_return(section);
  if (kind == names::crank_rocker) return read_crank_rocker(section);
  return read_path(section, directory);
}

}  // namespace geneva::model
