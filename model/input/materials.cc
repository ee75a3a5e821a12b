#include "model/input/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>

#include "base/errors.h"
#include "model/input/case_values.h"
#include "model/input/nearest_word.h"

namespace geneva::model {

namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return text;
}

KnownMaterial read_known_material(const CaseValues& values, const ParameterText& text,
                                  const std::string& name) {
  const CaseSection section(values, {name});
  KnownMaterial material{};
  material.name = name;
  for (const Assignment& given : text.assignments)
    if (given.section == SectionPath{name}) material.texts[given.name] = given.value;
  material.youngs_modulus = section.value("Young's modulus");
  material.poissons_ratio = section.value("Poisson's ratio");
  material.density = section.value("Density");
  material.yield_strength = section.optional_value("Yield strength");
  material.fatigue_strength = section.optional_value("Fatigue strength");
  material.contact_pressure = section.optional_value("Contact pressure");
  material.hardness = section.optional_value("Hardness");
  if (const auto line = section.values("Pressure by hardness"); !line.empty())
    material.pressure_by_hardness = std::make_pair(line[0], line[1]);
  if (const auto wear = section.values("Wear coefficient"); !wear.empty()) {
    if (wear[0] > wear[1])
      section.refuse("Wear coefficient", "the lesser one comes first, then the greater");
    material.wear = std::make_pair(wear[0], wear[1]);
  }
  material.also_called = section.text("Also called");
  material.source = section.text("Source");
  return material;
}

void add_materials(std::vector<KnownMaterial>& materials, const ParameterText& text) {
  std::vector<Parameter> parameters;
  for (const OpenedSection& section : text.sections)
    for (const Parameter& parameter : known_material_parameters(section.path.front()))
      if (section.path.size() == 1) parameters.push_back(parameter);
  const CaseValues values(parameters, text);
  for (const OpenedSection& section : text.sections) {
    KnownMaterial found = read_known_material(values, text, section.path.front());
    const auto same =
        std::find_if(materials.begin(), materials.end(), [&](const KnownMaterial& other) {
          return lower_case(other.name) == lower_case(found.name);
        });
    if (same == materials.end())
      materials.push_back(std::move(found));
    else
      *same = std::move(found);
  }
}

/// Of the XDG base directory specification.
fs::path user_file() {
  const char* const configuration = std::getenv("XDG_CONFIG_HOME");
  if (configuration != nullptr && fs::path(configuration).is_absolute())
    return fs::path(configuration) / "geneva" / "materials.prm";
  const char* const home = std::getenv("HOME");
  return home == nullptr ? fs::path() : fs::path(home) / ".config" / "geneva" / "materials.prm";
}

void add_file(std::vector<KnownMaterial>& materials, const fs::path& file) {
  std::error_code error;
  if (!file.empty() && fs::exists(file, error)) add_materials(materials, read_parameter_text(file));
}

/// Without what people write in one way or the other: "PA66" is "PA 66".
std::string plain(const std::string& name) {
  std::string text;
  for (const char letter : lower_case(name))
    if (letter != ' ' && letter != '-') text += letter;
  return text;
}

/// The first word of a name, which is its grade: "C45" of "C45 normalised".
std::string grade_of(const std::string& name) { return lower_case(name.substr(0, name.find(' '))); }

/// The names of the grade that somebody may have meant, however it is treated; empty if there is
/// none like it.
std::vector<std::string> of_nearest_grade(const std::string& name,
                                          const std::vector<std::string>& names) {
  std::vector<std::string> grades;
  for (const std::string& each : names) grades.push_back(grade_of(each));
  const auto nearest = nearest_word(grade_of(name), grades);
  std::vector<std::string> found;
  for (const std::string& each : names)
    if (nearest && grade_of(each) == *nearest) found.push_back(each);
  return found;
}

/// @throws base::InputError naming what may have been meant by an unknown name
[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<std::string>& names,
                                 const std::vector<std::string>& containing) {
  if (containing.size() > 1)
    throw base::InputError(fmt::format("one of {} is wanted", listed(containing)));
  const auto nearest = containing.empty() ? nearest_word(name, names) : containing.front();
  const std::vector<std::string> of_grade = of_nearest_grade(name, names);
  const std::string meant = nearest ? base::in_quotes(*nearest)
                            : of_grade.size() > 1
                                ? "one of " + listed(of_grade)
                                : (of_grade.empty() ? "" : base::in_quotes(of_grade.front()));
  throw base::InputError(fmt::format("no such material is known{}; 'geneva materials' lists them",
                                     meant.empty() ? "" : ": did you mean " + meant + "?"));
}

}  // namespace

std::vector<KnownMaterial> known_materials(const fs::path& case_directory) {
  std::vector<KnownMaterial> materials;
  add_materials(materials, parameter_text("materials.prm", std::string(materials_file)));
  add_file(materials, user_file());
  if (!case_directory.empty()) add_file(materials, case_directory / "materials.prm");
  return materials;
}

const KnownMaterial& material_named(const std::vector<KnownMaterial>& materials,
                                    const std::string& name) {
  std::vector<std::string> names;
  std::vector<std::string> containing;
  for (const KnownMaterial& material : materials) {
    if (lower_case(material.name) == lower_case(name)) return material;
    names.push_back(material.name);
    const std::string texts = plain(material.name + ", " + material.also_called);
    if (!plain(name).empty() && texts.find(plain(name)) != std::string::npos)
      containing.push_back(material.name);
  }
  refuse_unknown(name, names, containing);
}

std::optional<double> flank_pressure(const KnownMaterial& material,
                                     const std::optional<double>& hardness) {
  if (hardness == material.hardness || !hardness) return material.contact_pressure;
  if (!material.pressure_by_hardness)
    return material.hardness && *hardness < *material.hardness ? std::nullopt
                                                               : material.contact_pressure;
  return material.pressure_by_hardness->first * *hardness + material.pressure_by_hardness->second;
}

std::map<SectionPath, KnownMaterial> take_materials(std::vector<Parameter>& parameters,
                                                    const ParameterText& text,
                                                    const fs::path& case_directory) {
  std::map<SectionPath, KnownMaterial> taken;
  for (const Assignment& given : text.assignments) {
    const auto is_asked_for = [&](const Parameter& parameter) {
      return parameter.section == given.section && parameter.name == names::material;
    };
    if (given.name != names::material || given.value.empty() ||
        std::none_of(parameters.begin(), parameters.end(), is_asked_for))
      continue;
    const std::vector<KnownMaterial> materials = known_materials(case_directory);
    try {
      taken[given.section] = material_named(materials, given.value);
    } catch (const base::InputError& error) {
      refuse(text, given, error.what());
    }
    const auto& texts = taken[given.section].texts;
    for (Parameter& parameter : parameters) {
      if (parameter.section != given.section) continue;
      // With another hardness it is another pressure.
      if (parameter.name == "Contact pressure" && text.find(given.section, "Hardness") != nullptr)
        continue;
      if (const auto value = texts.find(parameter.name); value != texts.end())
        parameter.default_value = value->second;
    }
  }
  return taken;
}

}  // namespace geneva::model
