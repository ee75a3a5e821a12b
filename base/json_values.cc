#include "base/json_values.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace geneva::base {

using nlohmann::json;

json quantity(const double value, const char* unit) {
  if (!std::isfinite(value)) return nullptr;
  return {{"value", value}, {"unit", unit}};
}

json quantity(const double value, const Dimension dimension) {
  if (dimension == Dimension::slope) return quantity(value, "rad");
  std::string unit = output_unit(UnitSystem::si, dimension).name;
  std::replace(unit.begin(), unit.end(), '.', ' ');
  return quantity(value, unit.c_str());
}

json finite(const double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json case_section(const CaseHeader& header) {
  return {{"name", header.name},
          {"title", header.title},
          {"project", header.project},
          {"author", header.author},
          {"date", header.date},
          {"output_units", name_of(header.units)},
          {"content", header.content},
          {"inputs", header.inputs},
          {"worked_out", header.worked_out}};
}

json versions_section(const std::string& geneva_version) {
  return {{"geneva", geneva_version}, {"results", results_format}};
}

}  // namespace geneva::base
