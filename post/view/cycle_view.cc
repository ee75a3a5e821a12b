#include "post/view/cycle_view.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "post/view/quantised.h"

namespace geneva::post {

using base::Dimension;
using nlohmann::json;

namespace {

json instant_section(const InstantField& instant, const base::OutputUnit& length,
                     const base::OutputUnit& stress) {
  std::vector<float> points;
  std::vector<float> values;
  std::vector<std::uint32_t> cells;
  for (const auto& place : instant.places)
    for (const std::size_t i : {0U, 1U})
      points.push_back(static_cast<float>(length.factor * place[i]));
  for (const double value : instant.von_mises)
    values.push_back(static_cast<float>(stress.factor * value));
  for (const auto& cell : instant.cells)
    for (const std::size_t node : cell) cells.push_back(static_cast<std::uint32_t>(node));
  const Quantised steps = quantised(values);
  return {{"points", base::encoded(points)},
          {"cells", base::encoded(cells)},
          {"low", steps.low},
          {"high", steps.high},
          {"steps", base::encoded(steps.steps)}};
}

}  // namespace

json cycle_view(const std::vector<InstantField>& instants, const base::UnitSystem units) {
  const base::OutputUnit length = base::output_unit(units, Dimension::length);
  const base::OutputUnit stress = base::output_unit(units, Dimension::stress);
  json list = json::array();
  for (const InstantField& instant : instants)
    list.push_back(instant_section(instant, length, stress));
  return {{"length_unit", length.name}, {"stress_unit", stress.name}, {"instants", list}};
}

}  // namespace geneva::post
