#include "app/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <system_error>
#include <vector>

#include "base/errors.h"
#include "model/input/materials.h"
#include "model/input/parameter_rule.h"

namespace geneva::app {

namespace {

std::string megapascals(const std::optional<double>& stress) {
  return stress ? fmt::format("{:.4g}", 1e-6 * *stress) : std::string("-");
}

/// "1e-16..2e-14", lubricated and dry.
std::string wear_range(const std::optional<std::pair<double, double>>& wear) {
  return wear ? fmt::format("{:.1g}..{:.1g}", wear->first, wear->second) : std::string("-");
}

void print_list(const std::vector<model::KnownMaterial>& materials) {
  std::size_t widest = 0;
  for (const model::KnownMaterial& material : materials)
    widest = std::max(widest, material.name.size());
  const auto row = [&](const std::string& name, const std::string& modulus, const std::string& nu,
                       const std::string& density, const std::string& yield,
                       const std::string& fatigue, const std::string& contact,
                       const std::string& wear) {
    std::cout << fmt::format("{:<{}}{:>5}{:>7}{:>8}{:>7}{:>9}{:>9}{:>16}\n", name, widest, modulus,
                             nu, density, yield, fatigue, contact, wear);
  };
  row("", "E", "nu", "density", "yield", "fatigue", "contact", "wear");
  row("", "GPa", "", "kg/m^3", "MPa", "MPa", "MPa", "m^2/N");
  for (const model::KnownMaterial& material : materials)
    row(material.name, fmt::format("{:.4g}", 1e-9 * material.youngs_modulus),
        fmt::format("{:.3g}", material.poissons_ratio), fmt::format("{:.4g}", material.density),
        megapascals(material.yield_strength), megapascals(material.fatigue_strength),
        megapascals(material.contact_pressure), wear_range(material.wear));
  std::cout
      << "Typical values, for orientation. 'geneva materials NAME' tells where they are from; "
         "'set Material = NAME'\ntakes them; a materials.prm in the case directory adds "
         "others (doc/materials.md).\n";
}

/// Of a text that is divided by semicolons.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    parts.push_back(model::trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

void print_one(const model::KnownMaterial& material) {
  const auto line = [](const char* const name, const std::string& value) {
    std::cout << fmt::format("  {:<22}{}\n", name, value);
  };
  std::cout << material.name << '\n';
  for (const model::Parameter& parameter : model::known_material_parameters(material.name)) {
    const auto text = material.texts.find(parameter.name);
    if (text == material.texts.end()) continue;
    const char* label = parameter.name.c_str();
    for (const std::string& part : parts_of(text->second)) {
      line(label, part);
      label = "";
    }
  }
}

}  // namespace

int show_materials(const std::string& name, const std::filesystem::path& case_directory) {
  std::error_code status;
  if (!std::filesystem::is_directory(case_directory, status))
    throw base::InputError(fmt::format("{}: there is no such directory", case_directory.string()));
  const std::vector<model::KnownMaterial> materials = model::known_materials(case_directory);
  if (name.empty()) {
    print_list(materials);
    return 0;
  }
  try {
    print_one(model::material_named(materials, name));
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("{}: {}", base::in_quotes(name), error.what()));
  }
  return 0;
}

}  // namespace geneva::app
