#include "post/report/shown_values.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace geneva::post {

double number_of(const nlohmann::json& quantity) {
  if (quantity.is_null()) return std::nan("");
  return (quantity.is_object() ? quantity.at("value") : quantity).get<double>();
}

double in_units(const nlohmann::json& quantity, const Dimension dimension, const UnitSystem units) {
  return number_of(quantity) * output_unit(units, dimension).factor;
}

std::string shown(const nlohmann::json& quantity, const Dimension dimension,
                  const UnitSystem units) {
  return quantity.is_null() ? "–" : fmt::format("{:.5g}", in_units(quantity, dimension, units));
}

std::string labelled(const std::string& name, const Dimension dimension, const UnitSystem units) {
  const std::string unit = output_unit(units, dimension).name;
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

}  // namespace geneva::post
