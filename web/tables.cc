// Writes what the page takes over from the program: units with their factors, and the materials.
//   tables MATERIALS_FILE OUTPUT

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/units.h"

namespace {

using geneva::base::Dimension;
using geneva::base::UnitSystem;
using nlohmann::json;

/// Dimensions of the page's inputs and figures.
constexpr std::array<Dimension, 12> dimensions{
    Dimension::length,        Dimension::angle,
    Dimension::angular_speed, Dimension::angular_acceleration,
    Dimension::stress,        Dimension::density,
    Dimension::force,         Dimension::moment,
    Dimension::inertia,       Dimension::time,
    Dimension::speed,         Dimension::pressure_times_speed};

/// The unit, what it is in SI units, and what an SI value is multiplied with to be shown in it.
json unit_section(const UnitSystem system, const Dimension dimension) {
  const geneva::base::OutputUnit unit = geneva::base::output_unit(system, dimension);
  return {{"unit", unit.name},
          {"scale", geneva::base::parse_quantity("1 " + unit.name, dimension)},
          {"factor", unit.factor}};
}

json units() {
  json systems = json::object();
  for (const UnitSystem system : {UnitSystem::mm_newton, UnitSystem::inch_pound}) {
    json& section = systems[name_of(system)];
    for (const Dimension dimension : dimensions)
      section[name_of(dimension)] = unit_section(system, dimension);
  }
  return systems;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Name and value of "set NAME = VALUE".
std::pair<std::string, std::string> assignment(const std::string& line) {
  const std::size_t equals = line.find('=');
  if (line.rfind("set ", 0) != 0 || equals == std::string::npos) return {};
  return {trimmed(line.substr(4, equals - 4)), trimmed(line.substr(equals + 1))};
}

json material(const std::string& name, const std::map<std::string, std::string>& values) {
  using geneva::base::parse_quantity;
  return {
      {"name", name},
      {"youngs_modulus", parse_quantity(values.at("Young's modulus"), Dimension::stress)},
      {"poissons_ratio", parse_quantity(values.at("Poisson's ratio"), Dimension::dimensionless)},
      {"density", parse_quantity(values.at("Density"), Dimension::density)}};
}

json materials(const char* file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(std::string(file) + " cannot be read");
  json list = json::array();
  std::string name;
  std::map<std::string, std::string> values;
  for (std::string line; std::getline(stream, line);) {
    const std::string text = trimmed(line);
    if (text.rfind("subsection ", 0) == 0) {
      name = trimmed(text.substr(11));
      values.clear();
    } else if (text == "end") {
      list.push_back(material(name, values));
    } else {
      values.insert(assignment(text));
    }
  }
  return list;
}

}  // namespace

int main(const int count, const char* const* const arguments) try {
  if (count != 3) throw std::runtime_error("usage: tables MATERIALS_FILE OUTPUT");
  std::ofstream output(arguments[2]);
  output << json{{"units", units()}, {"materials", materials(arguments[1])}} << '\n';
  output.close();
  if (!output) throw std::runtime_error(std::string(arguments[2]) + " cannot be written");
} catch (const std::exception& error) {
  std::fprintf(stderr, "tables: %s\n", error.what());
  return 1;
}
