#include "model/input/case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "base/errors.h"
#include "base/printable.h"
#include "model/input/case_content.h"
#include "model/input/case_models.h"
#include "model/input/case_values.h"
#include "model/input/parameter_listing.h"
#include "model/input/parameter_text.h"
#include "model/input/parameters.h"

namespace geneva::model {

namespace {

namespace fs = std::filesystem;

/// The directory without a slash at its end.
fs::path checked_directory(const fs::path& directory) {
  if (directory.empty())
    throw base::InputError("the case directory has no name: name a directory with a case.prm");
  std::error_code error;
  const std::string name = directory.string();
  if (!fs::exists(directory, error))
    throw base::InputError(fmt::format("{}: there is no such directory", name));
  if (!fs::is_directory(directory, error))
    throw base::InputError(
        fmt::format("{}: this is not a directory; name the directory that holds case.prm", name));
  if (!fs::exists(directory / "case.prm", error))
    throw base::InputError(fmt::format(
        "{}: there is no file case.prm in this directory; 'geneva init' writes one", name));
  return directory.has_filename() ? directory : directory.parent_path();
}

/// The model that the file asks for.
std::string model_of(const ParameterText& text) {
  const ChoiceRule rule = model_rule();
  const Assignment* found = text.find({}, "Model");
  if (found == nullptr) return rule.words.front();
  if (refusal(rule, found->value))
    refuse(text, *found, fmt::format("one of {} is wanted", listed(rule.words)));
  return found->value;
}

/// Refuses a subsection that belongs to another model than the case has.
void check_sections(const ParameterText& text, const std::string& model) {
  const std::map<std::string, std::vector<std::string>> models{
      {names::mechanism, {"mechanism"}},
      {names::geometry, {"geometry"}},
      {names::synthesis, {"synthesis"}},
      {names::optimisation, {"mechanism"}},
      {names::published, {"mechanism", "geometry"}},
      {names::allowable, {"mechanism", "geometry"}}};
  for (const OpenedSection& section : text.sections) {
    const auto known = models.find(section.path.front());
    if (known == models.end()) continue;
    const auto& allowed = known->second;
    if (std::find(allowed.begin(), allowed.end(), model) == allowed.end())
      refuse(
          text, section.line,
          fmt::format("the subsection '{}' belongs to Model = {}, but this case has Model = {}{}",
                      known->first, fmt::join(allowed, " or "), model,
                      text.find({}, "Model") == nullptr ? " (default)" : ""));
  }
}

std::vector<Parameter> parameters_of_model(const ParameterText& text, const std::string& model,
                                           const fs::path& directory) {
  std::vector<Parameter> parameters = general_parameters();
  const auto append = [&](const std::vector<Parameter>& more) {
    parameters.insert(parameters.end(), more.begin(), more.end());
  };
  if (model == "synthesis") {
    append(synthesis_parameters());
    return parameters;
  }
  append(settings_parameters());
  append(model == "mechanism" ? mechanism_parameters() : geometry_parameters_of(text, directory));
  if (model == "mechanism") append(optimisation_parameters());
  append(published_parameters());
  append(allowable_parameters());
  return parameters;
}

fem::LinearSolver read_linear_solver(const CaseSection& section) {
  const std::string word = section.text("Linear solver");
  if (word == "own") return fem::LinearSolver::own;
  return word == "ML" ? fem::LinearSolver::library : fem::LinearSolver::automatic;
}

bool has_contact(const Case& given) {
  return given.mechanism ||
         std::visit([](const auto& problem) { return fem::has_contact(problem); },
                    given.geometry->problem);
}

/// In 3-D beside a contact cells for it are dear.
std::optional<double> read_structural_accuracy(const CaseSection& section, const Case& given) {
  const std::string name = "Structural accuracy";
  if (section.text(name) == "off") return std::nullopt;
  return section.optional_value(name).value_or(given.dimension == 3 && has_contact(given) ? 0.05
                                                                                          : 0.02);
}

/// Of the contact pressure; without contact that of the maxima of stress counts alone, and with
/// neither one mesh is enough.
double read_accuracy(const CaseSection& section, const Case& given,
                     const std::optional<double> structural) {
  if (has_contact(given))
    return section.optional_value("Accuracy").value_or(given.dimension == 3 ? 0.05 : 0.005);
  if (section.is_changed("Accuracy"))
    section.refuse("Accuracy",
                   "it is that of the contact pressure, and the case has no 'Contact pairs'; "
                   "'Structural accuracy' is that of the maximum stress");
  return structural.value_or(1.);
}

fem::Settings read_settings(const CaseSection& section, const Case& given) {
  fem::Settings settings;
  settings.structural_accuracy = read_structural_accuracy(section, given);
  settings.accuracy = read_accuracy(section, given, settings.structural_accuracy);
  settings.max_levels = static_cast<unsigned int>(section.value("Maximum refinement levels"));
  settings.max_dofs = static_cast<unsigned int>(section.value("Maximum unknowns"));
  settings.max_memory = section.value("Maximum memory");
  settings.max_seconds = section.value("Maximum time");
  settings.max_active_set_steps =
      static_cast<unsigned int>(section.value("Maximum active-set steps"));
  settings.linear_tolerance = section.value("Linear tolerance");
  settings.linear_solver = read_linear_solver(section);
  return settings;
}

Checkpoints read_checkpoints(const CaseSection& section) {
  const std::string word = section.text("Checkpoint");
  if (word == "true") return Checkpoints::always;
  return word == "false" ? Checkpoints::never : Checkpoints::automatic;
}

/// Names of the bodies and the subsections of their materials.
std::map<std::string, SectionPath> materials_of(const Case& given) {
  std::map<std::string, SectionPath> sections;
  if (given.mechanism) {
    sections = {{"pin", {names::mechanism, names::pin_material}},
                {"wheel", {names::mechanism, names::wheel_material}}};
    if (given.mechanism->roller) sections["stud"] = {names::mechanism, names::stud_material};
    return sections;
  }
  std::visit(
      [&](const auto& problem) {
        for (const auto& body : problem.bodies) sections[body.name] = body_section(body.name);
      },
      given.geometry->problem);
  return sections;
}

/// Files of the case directory that the case names.
std::vector<fs::path> named_files(const CaseValues& values, const Case& given) {
  std::vector<fs::path> files;
  std::error_code error;
  if (!given.materials.empty() && fs::exists(given.directory / "materials.prm", error))
    files.push_back(given.directory / "materials.prm");
  const auto add = [&](const SectionPath& section, const char* parameter) {
    const std::string name = CaseSection(values, section).text(parameter);
    if (!name.empty()) files.push_back(given.directory / name);
  };
  if (given.mechanism) {
    add({names::mechanism}, "Motion table");
    add({names::mechanism, names::pin}, "Profile table");
  }
  if (given.geometry) {
    files.push_back(given.geometry->file);
    add({names::geometry}, "Load steps");
  }
  if (given.synthesis)
    if (const auto* path = std::get_if<PathCase>(&*given.synthesis)) files.push_back(path->file);
  return files;
}

/// Refuses what compares a contact pressure where there is no contact.
void refuse_limits_of_contact(const CaseValues& values, const Case& given) {
  if (has_contact(given)) return;
  const auto refuse = [&](const char* const name, const char* const parameter) {
    const CaseSection section(values, {name});
    if (section.is_changed(parameter))
      section.refuse(parameter, "the case has no 'Contact pairs', and so no contact pressure");
  };
  refuse(names::allowable, "Contact pressure");
  refuse(names::published, "Peak pressure");
}

/// @throws base::InputError for a depth without a hardness
std::optional<loads::HardenedLayer> read_layer(const CaseSection& material) {
  const auto depth = material.optional_value("Hardened depth");
  if (!depth) return std::nullopt;
  const auto hardness = material.optional_value("Hardness");
  if (!hardness)
    material.refuse("Hardened depth",
                    "'Hardness' is missing: it gives the yield strength of the hardened layer");
  if (!material.optional_value("Yield strength"))
    material.refuse("Hardened depth", "'Yield strength' is missing: that of the core below it");
  return loads::HardenedLayer{*depth, loads::yield_strength_by_hardness(*hardness)};
}

loads::Allowables read_allowables(const CaseValues& values, const Case& given) {
  const CaseSection section(values, {names::allowable});
  loads::Allowables result{section.optional_value("Contact pressure"),
                           section.optional_value("Pressure times slip speed"),
                           {},
                           {},
                           {},
                           {}};
  if (result.pressure_times_slip && !given.mechanism)
    section.refuse("Pressure times slip speed",
                   "a geometry knows no slip speed; it is for Model = mechanism");
  if (result.pressure_times_slip && given.mechanism->roller && given.mechanism->roller->needles)
    section.refuse("Pressure times slip speed",
                   "a roller on needles slides neither on the wall nor in its bore");
  for (const auto& [body, path] : materials_of(given))
    if (const auto yield = CaseSection(values, path).optional_value("Yield strength"))
      result.yield_strengths[body] = *yield;
  for (const auto& [body, path] : materials_of(given))
    if (const auto fatigue = CaseSection(values, path).optional_value("Fatigue strength"))
      result.fatigue_strengths[body] = *fatigue;
  for (const auto& [body, path] : materials_of(given))
    if (const auto layer = read_layer(CaseSection(values, path))) result.layers[body] = *layer;
  for (const auto& [body, path] : materials_of(given)) {
    const CaseSection of_body(values, path);
    const auto named = given.materials.find(body);
    const auto pressure = of_body.is_given("Contact pressure")
                              ? of_body.optional_value("Contact pressure")
                          : named == given.materials.end()
                              ? std::nullopt
                              : flank_pressure(named->second, of_body.optional_value("Hardness"));
    if (pressure && has_contact(given)) result.flank_pressures[body] = *pressure;
  }
  return result;
}

/// Where a case names a material and gives another Young's modulus: that a sweep over materials
/// changes nothing then is easily overlooked.
std::vector<std::string> conflicts_of(const std::map<SectionPath, KnownMaterial>& materials,
                                      const CaseValues& values) {
  constexpr double same = 0.1;
  std::vector<std::string> notices;
  for (const auto& [section, material] : materials) {
    const double given = CaseSection(values, section).value("Young's modulus");
    if (std::abs(given / material.youngs_modulus - 1.) > same)
      notices.push_back(fmt::format(
          "'{}/Young's modulus' is {:.4g} GPa as the case gives it, not {:.4g} GPa as that of "
          "'{}': leave it out to have the material's",
          section.back(), 1e-9 * given, 1e-9 * material.youngs_modulus, material.name));
  }
  return notices;
}

void read_models_of_mechanism(const CaseValues& values, Case& result) {
  result.mechanism = read_mechanism(values, result.directory);
  result.optimisation = read_optimisation(values, *result.mechanism);
}

}  // namespace

Case read_case(const fs::path& directory) {
  const fs::path checked = checked_directory(directory);
  return case_of(read_parameter_text(checked / "case.prm"), checked);
}

Case case_of(const ParameterText& text, const fs::path& directory) {
  Case result{};
  result.directory = directory;
  result.text = text;
  const std::string model = model_of(text);
  check_sections(text, model);
  std::vector<Parameter> parameters = parameters_of_model(text, model, result.directory);
  const std::map<SectionPath, KnownMaterial> materials =
      take_materials(parameters, text, result.directory);
  const CaseValues values(parameters, text);

  const CaseSection general(values, {});
  result.title = base::without_controls(general.text("Title"));
  result.project = base::without_controls(general.text("Project"));
  result.author = base::without_controls(general.text("Author"));
  result.units = base::unit_system_named(general.text("Output units"));
  if (model == "synthesis") {
    result.synthesis = read_synthesis(values, result.directory);
  } else {
    result.dimension = general.text("Dimension") == "3" ? 3 : 2;
    result.checkpoints = read_checkpoints(general);
    const CaseSection published(values, {names::published});
    result.published_peak_pressure = published.optional_value("Peak pressure");
    result.published_source = published.text("Source");
    if (model == "mechanism")
      read_models_of_mechanism(values, result);
    else
      result.geometry = read_geometry_case(values, result.directory, result.dimension);
    result.settings = read_settings(general, result);
    refuse_limits_of_contact(values, result);
    for (const auto& [body, section] : materials_of(result))
      if (const auto named = materials.find(section); named != materials.end())
        result.materials[body] = named->second;
    result.allowed = read_allowables(values, result);
    result.notices = conflicts_of(materials, values);
  }
  result.completed = values.completed();
  const std::vector<fs::path> others = named_files(values, result);
  result.inputs = {result.directory / "case.prm"};
  result.inputs.insert(result.inputs.end(), others.begin(), others.end());
  result.content = content_of(result.completed, model, others);
  return result;
}

std::vector<Parameter> parameters_of(const ParameterText& text, const fs::path& directory) {
  return parameters_of_model(text, model_of(text), directory);
}

std::string name_of(const Case& given) {
  const fs::path path = (fs::absolute(given.directory) / "").lexically_normal();
  return path.parent_path().filename().string();
}

void refuse_model(const Case& given, const std::string& reason, const std::string& command,
                  const std::string& wanted) {
  const std::string model = given.mechanism  ? "mechanism"
                            : given.geometry ? "geometry"
                                             : "synthesis";
  throw base::InputError(
      fmt::format("'Model' = '{}': {}; '{}' wants a case with Model = {}{}", model, reason, command,
                  wanted, given.synthesis ? ", this one is for 'geneva synthesize'" : ""));
}

std::string parameter_file() {
  std::vector<Parameter> all;
  for (const std::vector<Parameter>& some :
       {general_parameters(), settings_parameters(), mechanism_parameters(),
        optimisation_parameters(),
        geometry_parameters({"NAME"}, {"NAME"}, {"Surface NAME", "Solid NAME"}, ""),
        synthesis_parameters(), published_parameters(), allowable_parameters()})
    all.insert(all.end(), some.begin(), some.end());
  return parameter_listing(
      all, [](const Parameter& parameter) { return parameter.default_value; },
      [](const Parameter&) { return false; });
}

}  // namespace geneva::model
