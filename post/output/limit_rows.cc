#include "post/output/limit_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/json_values.h"

namespace geneva::post {

double LimitRow::factor() const {
  return value > 0. ? allowed / value : std::numeric_limits<double>::infinity();
}

std::optional<double> least_factor(const std::vector<LimitRow>& rows) {
  std::optional<double> least;
  for (const LimitRow& row : rows) least = std::min(row.factor(), least.value_or(row.factor()));
  return least;
}

nlohmann::json limits_section(const std::vector<LimitRow>& rows) {
  using base::quantity;
  nlohmann::json list = nlohmann::json::array();
  for (const LimitRow& row : rows)
    list.push_back(
        {{"quantity", row.quantity},
         {"dimension", base::name_of(row.dimension)},
         {"computed", quantity(row.value, row.dimension)},
         {"allowed", quantity(row.allowed, row.dimension)},
         {"factor", base::finite(row.factor())},
         {"driver_angle", row.driver_angle ? quantity(*row.driver_angle, base::Dimension::angle)
                                           : nlohmann::json()},
         {"meaning", row.meaning}});
  return list;
}

std::string limit_lines(const std::vector<LimitRow>& rows, const base::UnitSystem units) {
  const base::OutputUnit angle = base::output_unit(units, base::Dimension::angle);
  std::string text;
  for (const LimitRow& row : rows) {
    const base::OutputUnit unit = base::output_unit(units, row.dimension);
    text += fmt::format("{}: {:.5g} of {:.5g} {} allowed, safety factor {:.3g}{}{}\n", row.quantity,
                        row.value * unit.factor, row.allowed * unit.factor, unit.name, row.factor(),
                        row.factor() < 1. ? ", EXCEEDED" : "",
                        row.driver_angle ? fmt::format(" at {:.5g} {}",
                                                       *row.driver_angle * angle.factor, angle.name)
                                         : "");
  }
  return text;
}

}  // namespace geneva::post
