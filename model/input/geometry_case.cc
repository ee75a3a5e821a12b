#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <system_error>

#include "base/errors.h"
#include "model/input/case_models.h"
#include "model/input/case_path.h"
#include "model/input/geometry_file.h"
#include "model/input/load_steps.h"

namespace geneva::model {

namespace {

namespace fs = std::filesystem;
using base::Dimension;

constexpr std::size_t most_names = 1000;

/// Names of a list that is not empty.
std::vector<std::string> names_in(const ParameterText& text, const std::string& parameter) {
  const Assignment* found = text.find({names::geometry}, parameter);
  if (found == nullptr || found->value.empty()) return {};
  std::vector<std::string> parts = split_list(found->value);
  if (parts.size() > most_names)
    refuse(text, *found, fmt::format("at most {} names are allowed", most_names));
  std::set<std::string> seen;
  for (const std::string& name : parts) {
    if (name.empty()) refuse(text, *found, "a name between commas is empty");
    if (!seen.insert(name).second)
      refuse(text, *found, fmt::format("the name {} stands there twice", base::in_quotes(name)));
  }
  return parts;
}

fem::PlaneKind read_plane(const CaseSection& section) {
  const std::string plane = section.text("Plane");
  if (plane == "axisymmetric") return fem::PlaneKind::axisymmetric;
  return plane == "plane stress" ? fem::PlaneKind::plane_stress : fem::PlaneKind::plane_strain;
}

double read_thickness(const CaseSection& section, fem::PlaneKind plane) {
  const auto thickness = section.optional_value("Thickness");
  if (plane == fem::PlaneKind::axisymmetric) {
    if (thickness) section.refuse("Thickness", "an axisymmetric model has no thickness: delete it");
    return 1.;
  }
  if (!thickness)
    section.refuse_missing(
        "Thickness", "a plane model needs it, for example " + base::example_of(Dimension::length));
  return *thickness;
}

/// Refuses values that describe what a plane stands for.
void check_no_plane(const CaseSection& section) {
  for (const char* const name : {"Plane", "Thickness"})
    if (section.is_changed(name))
      section.refuse(name, "this has an effect with Dimension = 2 only: delete it");
}

/// The components of a vector; nothing if it is not given and has no default.
template <int dim>
std::optional<fem::Components<dim>> read_vector(const CaseSection& section, const char* name) {
  const std::vector<double> given = section.values(name);
  if (given.empty()) return std::nullopt;
  fem::Components<dim> vector{};
  if (section.is_changed(name) && given.size() != vector.size())
    section.refuse(name, fmt::format("{} components are wanted with Dimension = {}",
                                     dim == 2 ? "two" : "three", dim));
  std::copy(given.begin(), given.end(), vector.begin());
  return vector;
}

template <int dim>
fem::Body<dim> read_body(const CaseValues& values, const std::string& name) {
  const CaseSection section(values, body_section(name));
  fem::Body<dim> body;
  body.name = name;
  body.material = {section.value("Young's modulus"), section.value("Poisson's ratio")};
  body.density = section.value("Density");
  body.force.uniform = *read_vector<dim>(section, "Body force");
  body.force.acceleration = *read_vector<dim>(section, "Gravity");
  body.force.spin = section.value("Angular speed");
  return body;
}

/// Directions that "x y" names; nothing if it is something else.
template <int dim>
std::optional<std::set<std::size_t>> directions_of(const std::string& text) {
  std::set<std::size_t> directions;
  if (text == "fixed")
    for (std::size_t i = 0; i < dim; ++i) directions.insert(i);
  else
    for (const char letter : text) {
      if (letter == ' ') continue;
      const std::size_t direction = std::string("xyz").substr(0, dim).find(letter);
      if (direction == std::string::npos || !directions.insert(direction).second)
        return std::nullopt;
    }
  return directions.empty() ? std::nullopt : std::optional(directions);
}

template <int dim>
std::vector<fem::Support<dim>> read_supports(const CaseSection& section) {
  std::vector<fem::Support<dim>> supports;
  if (!section.is_given("Supports")) return supports;
  std::set<std::string> seen;
  for (const std::string& part : split_list(section.text("Supports"))) {
    const std::size_t colon = part.rfind(':');
    const std::string surface = trimmed(part.substr(0, colon));
    const std::string kind = colon == std::string::npos ? "" : trimmed(part.substr(colon + 1));
    const auto directions = directions_of<dim>(kind);
    if (surface.empty() || !directions)
      section.refuse("Supports",
                     fmt::format("{}: 'surface: fixed', 'surface: x'{} 'surface: y'{} is wanted",
                                 base::in_quotes(part), dim == 2 ? " or" : ",",
                                 dim == 2 ? "" : " or 'surface: z'"));
    if (!seen.insert(surface).second)
      section.refuse("Supports", fmt::format("the surface {} stands there twice; 'fixed' holds it "
                                             "in all directions, 'x y' in two",
                                             base::in_quotes(surface)));
    fem::Support<dim> support{surface, {}};
    for (const std::size_t direction : *directions) support.displacement[direction] = 0.;
    supports.push_back(support);
  }
  return supports;
}

std::vector<fem::ContactPair> read_pairs(const CaseSection& section) {
  std::vector<fem::ContactPair> pairs;
  std::set<std::pair<std::string, std::string>> seen;
  const std::string arrow = "->";
  if (!section.is_given("Contact pairs")) return pairs;
  for (const std::string& part : split_list(section.text("Contact pairs"))) {
    const std::size_t place = part.find(arrow);
    const std::string source = trimmed(part.substr(0, place));
    const std::string target =
        place == std::string::npos ? "" : trimmed(part.substr(place + arrow.size()));
    if (source.empty() || target.empty() || target.find(arrow) != std::string::npos)
      section.refuse("Contact pairs",
                     fmt::format("{}: 'surface -> surface' is wanted", base::in_quotes(part)));
    if (source == target)
      section.refuse("Contact pairs",
                     fmt::format("the surface {} cannot touch itself", base::in_quotes(source)));
    if (!seen.emplace(source, target).second)
      section.refuse("Contact pairs",
                     fmt::format("the pair {} stands there twice", base::in_quotes(part)));
    pairs.push_back({source, target});
  }
  return pairs;
}

Dimension dimension_of_load(const std::string& type) {
  if (type == "force") return Dimension::force;
  if (type == "force per thickness") return Dimension::force_per_length;
  if (type == "displacement") return Dimension::length;
  return Dimension::stress;
}

double read_load_value(const CaseSection& section, const std::string& type) {
  QuantityRule rule;
  rule.dimension = dimension_of_load(type);
  const std::string value = section.text("Value");
  if (const auto reason = refusal(rule, value))
    section.refuse("Value",
                   fmt::format("for Type = {} {} is wanted, for example {}", type,
                               base::wanted(rule.dimension), base::example_of(rule.dimension)));
  return values(rule, value).front();
}

/// Unit vector of a load's direction.
template <int dim>
fem::Components<dim> read_direction(const CaseSection& section, const std::string& type) {
  const auto given = read_vector<dim>(section, "Direction");
  if (!given)
    section.refuse_missing("Direction", fmt::format("Type = {} needs it, for example '{}'", type,
                                                    dim == 2 ? "0, -1" : "0, -1, 0"));
  fem::Components<dim> direction = *given;
  double square = 0.;
  for (const double component : direction) square += component * component;
  const double length = std::sqrt(square);
  if (!std::isnormal(length)) section.refuse("Direction", "a direction that is not zero is wanted");
  for (double& component : direction) component /= length;
  return direction;
}

template <int dim>
void require_free(const CaseSection& section, const std::string& surface,
                  const fem::Problem<dim>& problem) {
  for (const fem::Support<dim>& support : problem.supports)
    if (support.surface == surface)
      section.refuse("Type", fmt::format("the surface {} cannot be in 'Supports' too: this load "
                                         "holds it already",
                                         base::in_quotes(surface)));
}

/// Refuses a load given per thickness where there is none.
template <int dim>
void require_thickness(const CaseSection& section, const fem::Problem<dim>& problem) {
  if (dim == 3) section.refuse("Type", "a model in 3-D has no thickness; Type = force is wanted");
  if (problem.plane == fem::PlaneKind::axisymmetric)
    section.refuse("Type", "an axisymmetric model has no thickness; Type = force is wanted");
}

template <int dim>
void read_load(const CaseValues& values, const std::string& surface, fem::Problem<dim>& problem) {
  const CaseSection section(values, load_section(surface));
  const std::string type = section.text("Type");
  const double value = read_load_value(section, type);
  if (type == "pressure") {
    if (section.is_given("Direction"))
      section.refuse("Direction",
                     "a pressure acts along the normal; Type = traction has a "
                     "direction");
    problem.loads.push_back({surface, value, {}});
    return;
  }
  const fem::Components<dim> direction = read_direction<dim>(section, type);
  fem::Components<dim> vector{};
  std::array<std::optional<double>, static_cast<std::size_t>(dim)> displacement;
  for (std::size_t i = 0; i < vector.size(); ++i) {
    vector[i] = value * direction[i];
    displacement[i] = vector[i];
  }
  if (type == "traction") {
    problem.loads.push_back({surface, 0., vector});
    return;
  }
  if (type == "force per thickness") require_thickness(section, problem);
  require_free(section, surface, problem);
  if (type == "displacement")
    problem.supports.push_back({surface, displacement});
  else
    problem.ties.push_back(
        {surface, direction, type == "force" ? value : value * problem.thickness});
}

/// Coefficients of friction: one for all pairs, or one for each.
void read_friction(const CaseSection& section, std::vector<fem::ContactPair>& pairs) {
  if (!section.is_changed("Friction coefficient")) return;
  const std::vector<double> given = section.values("Friction coefficient");
  if (pairs.empty()) section.refuse("Friction coefficient", "there are no 'Contact pairs'");
  if (given.size() != 1 && given.size() != pairs.size())
    section.refuse(
        "Friction coefficient",
        fmt::format("there are {} numbers and {} contact pairs; give one for all, or one "
                    "for each",
                    given.size(), pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i].friction.coefficient = given[given.size() == 1 ? 0 : i];
}

/// A traction as one load for each component, so that each may have its own history.
template <int dim>
std::vector<std::string> split_by_component(fem::Problem<dim>& problem) {
  const std::array<const char*, 3> axes{" x", " y", " z"};
  std::vector<std::string> names;
  std::vector<fem::SurfaceLoad<dim>> split;
  for (const fem::SurfaceLoad<dim>& load : problem.loads) {
    if (load.pressure != 0.) {
      split.push_back({load.surface, load.pressure, {}});
      names.push_back(load.surface);
    }
    for (std::size_t i = 0; i < dim; ++i) {
      if (load.traction[i] == 0.) continue;
      split.push_back({load.surface, 0., {}});
      split.back().traction[i] = load.traction[i];
      names.push_back(load.surface + axes[i]);
    }
  }
  problem.loads = split;
  return names;
}

/// Whether a column of the load steps, "top" or "top x", is meant for a load.
bool is_for(const std::string& column, const std::string& load) {
  return column == load || load == column + " x" || load == column + " y" || load == column + " z";
}

template <int dim>
void read_steps(const CaseSection& section, const fs::path& directory, fem::Problem<dim>& problem) {
  if (!section.is_given("Load steps")) return;
  const LoadSteps steps = read_load_steps(file_in_directory(section, "Load steps", directory));
  const std::vector<std::string> loads = split_by_component(problem);
  const auto ones = [](const std::size_t n) { return std::vector<double>(n, 1.); };
  problem.steps.assign(
      steps.factors.size(),
      {{}, ones(problem.loads.size()), ones(problem.ties.size()), ones(problem.supports.size())});
  for (std::size_t step = 0; step < steps.times.size(); ++step)
    problem.steps[step].time = steps.times[step];
  for (std::size_t column = 0; column < steps.loads.size(); ++column) {
    bool is_found = false;
    const auto set = [&](std::vector<double> fem::Load::*const shares, const std::size_t place) {
      is_found = true;
      for (std::size_t step = 0; step < steps.factors.size(); ++step)
        (problem.steps[step].*shares)[place] = steps.factors[step][column];
    };
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (is_for(steps.loads[column], loads[i])) set(&fem::Load::surface_loads, i);
    for (std::size_t i = 0; i < problem.ties.size(); ++i)
      if (problem.ties[i].surface == steps.loads[column]) set(&fem::Load::ties, i);
    for (std::size_t i = 0; i < problem.supports.size(); ++i)
      if (problem.supports[i].surface == steps.loads[column] &&
          section.text("Loads").find(steps.loads[column]) != std::string::npos)
        set(&fem::Load::supports, i);
    if (!is_found)
      section.refuse("Load steps",
                     fmt::format("the column {} is none of 'Loads', nor a component of one that is "
                                 "not zero",
                                 base::in_quotes(steps.loads[column])));
  }
}

template <int dim>
fem::Problem<dim> read_problem(const CaseValues& values, const fs::path& directory) {
  const CaseSection section(values, {names::geometry});
  fem::Problem<dim> problem;
  if constexpr (dim == 2) {
    problem.plane = read_plane(section);
    problem.thickness = read_thickness(section, problem.plane);
  } else {
    check_no_plane(section);
  }
  for (const std::string& body : split_list(section.text("Bodies")))
    problem.bodies.push_back(read_body<dim>(values, body));
  problem.supports = read_supports<dim>(section);
  problem.pairs = read_pairs(section);
  if (section.is_given("Loads"))
    for (const std::string& surface : split_list(section.text("Loads")))
      read_load(values, surface, problem);
  read_friction(section, problem.pairs);
  read_steps(section, directory, problem);
  return problem;
}

}  // namespace

std::vector<Parameter> geometry_parameters_of(const ParameterText& text,
                                              const fs::path& directory) {
  const Assignment* file = text.find({names::geometry}, "File");
  return geometry_parameters(
      names_in(text, "Bodies"), names_in(text, "Loads"), pick_names(text),
      file == nullptr ? default_geometry_file(text, directory) : file->value);
}

GeometryCase read_geometry_case(const CaseValues& values, const fs::path& directory,
                                const int dimension) {
  GeometryCase result{read_geometry_file(values, directory, dimension), {}};
  if (dimension == 3)
    result.problem = read_problem<3>(values, directory);
  else
    result.problem = read_problem<2>(values, directory);
  return result;
}

}  // namespace geneva::model
