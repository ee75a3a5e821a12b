#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_values.h"
#include "post/output/synthesis_output.h"

namespace geneva::post {

using base::quantity;
using base::versions_section;

using nlohmann::json;

namespace {

json position_section(const loads::QuickReturnPosition& position) {
  return {{"crank_angle", quantity(position.crank_angle, "rad")},
          {"rocker_angle", quantity(position.rocker_angle, "rad")},
          {"slider_distance", quantity(position.slider_distance, "m")},
          {"rocker_speed", quantity(position.rocker_speed, "rad/s")},
          {"slider_speed", quantity(position.slider_speed, "m/s")}};
}

json position_section(const RockerPosition& position) {
  return {{"crank_angle", quantity(position.crank_angle, "rad")},
          {"coupler_angle", quantity(position.coupler_angle, "rad")},
          {"rocker_angle", quantity(position.rocker_angle, "rad")},
          {"speed_ratio", position.speed_ratio},
          {"transmission_angle", quantity(position.transmission_angle, "rad")}};
}

json dimensions_section(const loads::FourBar& linkage) {
  return {{"crank_pivot_x", quantity(linkage.crank_pivot[0], "m")},
          {"crank_pivot_y", quantity(linkage.crank_pivot[1], "m")},
          {"rocker_pivot_x", quantity(linkage.rocker_pivot[0], "m")},
          {"rocker_pivot_y", quantity(linkage.rocker_pivot[1], "m")},
          {"crank", quantity(linkage.crank, "m")},
          {"coupler", quantity(linkage.coupler, "m")},
          {"rocker", quantity(linkage.rocker, "m")},
          {"frame", quantity(loads::frame_length(linkage), "m")},
          {"crank_turns_fully", loads::crank_turns_fully(linkage)}};
}

std::pair<const char*, json> section_of(const QuickReturnReport& report) {
  const loads::QuickReturn& mechanism = report.mechanism;
  const loads::QuickReturnExtremes& extremes = report.extremes;
  return {"quick_return",
          {{"stations", mechanism.stations},
           {"maximum_wheel_speed", quantity(report.maximum_wheel_speed, "rad/s")},
           {"crank", quantity(mechanism.crank, "m")},
           {"frame", quantity(mechanism.centre_distance, "m")},
           {"crank_speed", quantity(mechanism.crank_speed, "rad/s")},
           {"k_t", mechanism.motion_ratio},
           {"engagement_angle", quantity(report.engagement, "rad")},
           {"extreme_positions",
            {{"slider_nearest", position_section(extremes.slider_nearest)},
             {"slider_farthest", position_section(extremes.slider_farthest)},
             {"rocker_first", position_section(extremes.rocker_first)},
             {"rocker_last", position_section(extremes.rocker_last)}}}}};
}

std::pair<const char*, json> section_of(const CrankRockerReport& report) {
  json section = dimensions_section(report.mechanism.linkage);
  section["assembly"] = "open";
  section["minimum_transmission_angle"] =
      quantity(report.mechanism.minimum_transmission_angle, "rad");
  section["swing"] = quantity(report.swing, "rad");
  section["time_ratio"] = report.time_ratio;
  section["extreme_positions"] = {{"rocker_farthest", position_section(report.farthest)},
                                  {"rocker_nearest", position_section(report.nearest)}};
  return {"crank_rocker", section};
}

/// Key of a given dimension, the same as in the solutions.
const char* key_of(const loads::PathDimension dimension) {
  constexpr std::array<const char*, 9> keys{"crank_pivot_x",  "crank_pivot_y",  "rocker_pivot_x",
                                            "rocker_pivot_y", "crank",          "coupler",
                                            "rocker",         "point_distance", "point_angle"};
  return keys.at(static_cast<std::size_t>(dimension));
}

json solution_section(const loads::PathSolution& solution) {
  json section = dimensions_section(solution.linkage);
  section["point_distance"] = quantity(solution.linkage.point_distance, "m");
  section["point_angle"] = quantity(solution.linkage.point_angle, "rad");
  section["residual"] = quantity(solution.residual, "m");
  section["iterations"] = solution.iterations;
  section["needs_reassembly"] = solution.needs_reassembly;
  section["out_of_order"] = solution.out_of_order;
  section["crank_angles"] = json::array();
  for (const double angle : solution.crank_angles)
    section["crank_angles"].push_back(quantity(angle, "rad"));
  section["assemblies"] = json::array();
  for (const loads::Assembly assembly : solution.assemblies)
    section["assemblies"].push_back(assembly == loads::Assembly::open ? "open" : "crossed");
  return section;
}

std::pair<const char*, json> section_of(const PathReport& report) {
  json section{{"starts", report.synthesis.starts},
               {"seed", report.task.seed},
               {"degenerate_starts", report.synthesis.degenerate},
               {"minimum_residual", quantity(report.synthesis.minimum_residual, "m")},
               {"points", json::array()},
               {"given", json::object()},
               {"solutions", json::array()}};
  for (const auto& point : report.task.points)
    section["points"].push_back({{"x", quantity(point[0], "m")}, {"y", quantity(point[1], "m")}});
  for (const auto& [dimension, value] : report.task.given)
    section["given"][key_of(dimension)] =
        quantity(value, dimension == loads::PathDimension::point_angle ? "rad" : "m");
  for (const loads::PathSolution& solution : report.synthesis.solutions)
    section["solutions"].push_back(solution_section(solution));
  return {"path", section};
}

}  // namespace

json synthesis_summary(const SynthesisReport& report) {
  const auto [kind, section] =
      std::visit([](const auto& result) { return section_of(result); }, report.result);
  return {{"case", {{"name", report.case_name}, {"title", report.title}}},
          {"kind", kind},
          {kind, section},
          {"versions", versions_section(report.geneva_version)}};
}

}  // namespace geneva::post
