#include "post/report/sections/closed_verdict.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::UnitSystem;
using nlohmann::json;

namespace {

const json* estimate_row(const json& estimate, const std::string& quantity) {
  for (const json& row : estimate.at("estimate"))
    if (row.at("quantity") == quantity) return &row;
  return nullptr;
}

std::string answer_of_estimate(const json& estimate, const UnitSystem units) {
  const json* const pressure = estimate_row(estimate, "greatest pressure of the engagement");
  const json* const angle = estimate_row(estimate, "its driver angle");
  if (pressure == nullptr || angle == nullptr) return "";
  return answer("greatest pressure of the engagement",
                shown_with_unit(pressure->at("value"), Dimension::stress, units),
                "by " + escaped(pressure->at("basis")) + " " + at_angle(angle->at("value"), units));
}

std::string answer_of_motion(const json& kinematics, const UnitSystem units) {
  const auto greatest = [&](const char* const key, const char* const name,
                            const Dimension dimension) {
    return answer(name, shown_with_unit(kinematics.at(key), dimension, units),
                  at_angle(kinematics.at(std::string(key) + "_angle"), units));
  };
  return greatest("peak_hertz_pressure", "greatest Hertz pressure", Dimension::stress) +
         greatest("peak_force", "greatest pin force", Dimension::force);
}

}  // namespace

ReportPart closed_verdict_part(const ResultsDirectory& results) {
  const json* const estimate = results.document("estimate");
  const json* const kinematics = results.document("kinematics");
  if (estimate == nullptr && kinematics == nullptr) return {};
  const json& leading = estimate != nullptr ? *estimate : *kinematics;
  const UnitSystem units = results.units();
  const json safety = leading.value("safety", json::array());
  return {
      html_section("verdict", "Verdict",
                   (estimate != nullptr ? answer_of_estimate(*estimate, units)
                                        : answer_of_motion(*kinematics, units)) +
                       nearest_limit(safety, units) +
                       limits_table(safety, "How near to the limits, by the closed forms", units)),
      {}};
}

}  // namespace geneva::post
