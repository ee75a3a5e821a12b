#include "post/output/synthesis_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

namespace {

constexpr std::size_t most_solutions = 12;  // of the table on the terminal

/// A value with its name and dimension, in rows and columns of every output here.
struct Entry {
  std::string name;
  double value;
  Dimension dimension = Dimension::dimensionless;
};

using Entries = std::vector<Entry>;

std::string heading(const Entry& entry, const UnitSystem units) {
  const std::string unit = output_unit(units, entry.dimension).name;
  return unit.empty() ? entry.name : fmt::format("{} [{}]", entry.name, unit);
}

double in_units(const Entry& entry, const UnitSystem units) {
  return entry.value * output_unit(units, entry.dimension).factor;
}

/// Roundings and minus signs of what is 0 do not show.
std::string shown(const Entry& entry, const UnitSystem units) {
  return fmt::format("{:.6g}", std::abs(entry.value) < 1e-12 ? 0. : in_units(entry, units));
}

/// The names of the entries of a row as the heading of a comma-separated file.
std::string csv_heading(const Entries& row, const UnitSystem units) {
  std::string text;
  for (const Entry& entry : row) text += (text.empty() ? "" : ",") + heading(entry, units);
  return text + "\n";
}

std::string csv_row(const Entries& row, const UnitSystem units) {
  std::string text;
  for (const Entry& entry : row)
    text += (text.empty() ? "" : ",") + fmt::format("{:.12g}", in_units(entry, units));
  return text + "\n";
}

/// A line for each value.
std::string value_lines(const Entries& entries, const UnitSystem units) {
  std::string text;
  for (const Entry& entry : entries)
    text += fmt::format("{:<52} {:>12}\n", heading(entry, units), shown(entry, units));
  return text;
}

/// A line for each named position under the headings of the first.
std::string position_lines(const std::vector<std::pair<std::string, Entries>>& rows,
                           const UnitSystem units) {
  constexpr int name_width = 18;
  std::string text = fmt::format("{:<{}}", "extreme positions", name_width);
  for (const Entry& entry : rows.front().second)
    text += fmt::format("  {:>20}", heading(entry, units));
  text += '\n';
  for (const auto& [name, row] : rows) {
    text += fmt::format("{:<{}}", name, name_width);
    for (const Entry& entry : row) text += fmt::format("  {:>20}", shown(entry, units));
    text += '\n';
  }
  return text;
}

Entries entries_of(const loads::QuickReturnPosition& position, const char* gap) {
  const auto name = [&](const char* what, const char* of) {
    return fmt::format("{}{}{}", what, gap, of);
  };
  return {{name("crank", "angle"), position.crank_angle, Dimension::angle},
          {name("rocker", "angle"), position.rocker_angle, Dimension::angle},
          {name("slider", "distance"), position.slider_distance, Dimension::length},
          {name("rocker", "speed"), position.rocker_speed, Dimension::angular_speed},
          {name("slider", "speed"), position.slider_speed, Dimension::speed}};
}

Entries entries_of(const RockerPosition& position, const char* gap) {
  const auto name = [&](const char* what, const char* of) {
    return fmt::format("{}{}{}", what, gap, of);
  };
  return {{name("crank", "angle"), position.crank_angle, Dimension::angle},
          {name("coupler", "angle"), position.coupler_angle, Dimension::angle},
          {name("rocker", "angle"), position.rocker_angle, Dimension::angle},
          {name("speed", "ratio"), position.speed_ratio},
          {name("transmission", "angle"), position.transmission_angle, Dimension::angle}};
}

template <typename Position>
std::string positions_csv(const std::vector<Position>& positions, const UnitSystem units) {
  std::string text = csv_heading(entries_of(positions.front(), "_"), units);
  for (const Position& position : positions) text += csv_row(entries_of(position, "_"), units);
  return text;
}

std::string csv_of(const QuickReturnReport& report, const UnitSystem units) {
  return positions_csv(report.positions, units);
}

std::string csv_of(const CrankRockerReport& report, const UnitSystem units) {
  return positions_csv(report.positions, units);
}

Entries entries_of(const loads::PathSolution& solution) {
  const loads::FourBar& linkage = solution.linkage;
  Entries row{{"crank_pivot_x", linkage.crank_pivot[0], Dimension::length},
              {"crank_pivot_y", linkage.crank_pivot[1], Dimension::length},
              {"rocker_pivot_x", linkage.rocker_pivot[0], Dimension::length},
              {"rocker_pivot_y", linkage.rocker_pivot[1], Dimension::length},
              {"crank", linkage.crank, Dimension::length},
              {"coupler", linkage.coupler, Dimension::length},
              {"rocker", linkage.rocker, Dimension::length},
              {"point_distance", linkage.point_distance, Dimension::length},
              {"point_angle", linkage.point_angle, Dimension::angle},
              {"residual", solution.residual, Dimension::length},
              {"needs_reassembly", solution.needs_reassembly ? 1. : 0.},
              {"out_of_order", solution.out_of_order ? 1. : 0.}};
  for (std::size_t i = 0; i < solution.crank_angles.size(); ++i)
    row.push_back(
        {fmt::format("crank_angle_{}", i + 1), solution.crank_angles[i], Dimension::angle});
  return row;
}

std::string csv_of(const PathReport& report, const UnitSystem units) {
  const loads::PathSolution none{
      {}, std::vector<double>(report.task.points.size()), {}, 0., 0, false, false};
  std::string text = csv_heading(entries_of(none), units);
  for (const loads::PathSolution& solution : report.synthesis.solutions)
    text += csv_row(entries_of(solution), units);
  return text;
}

std::string table_of(const QuickReturnReport& report, const UnitSystem units) {
  const loads::QuickReturn& mechanism = report.mechanism;
  const loads::QuickReturnExtremes& extremes = report.extremes;
  return fmt::format("quick-return mechanism for an external Geneva with {} stations\n",
                     mechanism.stations) +
         value_lines({{"crank AB", mechanism.crank, Dimension::length},
                      {"frame AD", mechanism.centre_distance, Dimension::length},
                      {"crank speed omega_2", mechanism.crank_speed, Dimension::angular_speed},
                      {"motion time over dwell time of the Geneva, k_t", mechanism.motion_ratio},
                      {"crank angle in engagement", report.engagement, Dimension::angle}},
                     units) +
         position_lines({{"slider nearest", entries_of(extremes.slider_nearest, " ")},
                         {"slider farthest", entries_of(extremes.slider_farthest, " ")},
                         {"rocker first", entries_of(extremes.rocker_first, " ")},
                         {"rocker last", entries_of(extremes.rocker_last, " ")}},
                        units);
}

std::string table_of(const CrankRockerReport& report, const UnitSystem units) {
  const loads::CrankRocker& mechanism = report.mechanism;
  const loads::FourBar& linkage = mechanism.linkage;
  return fmt::format("crank-rocker, rocker's pivot D at the origin; the crank {}\n",
                     report.crank_turns_fully ? "turns fully" : "does not turn fully") +
         value_lines({{"crank AB", linkage.crank, Dimension::length},
                      {"coupler BC", linkage.coupler, Dimension::length},
                      {"rocker CD", linkage.rocker, Dimension::length},
                      {"frame AD", mechanism.frame, Dimension::length},
                      {"crank's pivot A, x", linkage.crank_pivot[0], Dimension::length},
                      {"crank's pivot A, y", linkage.crank_pivot[1], Dimension::length},
                      {"swing of the rocker", report.swing, Dimension::angle},
                      {"times forward and back, ratio", report.time_ratio},
                      {"minimum transmission angle", mechanism.minimum_transmission_angle,
                       Dimension::angle}},
                     units) +
         position_lines({{"rocker farthest", entries_of(report.farthest, " ")},
                         {"rocker nearest", entries_of(report.nearest, " ")}},
                        units);
}

std::string remarks(const loads::PathSolution& solution) {
  std::string text = loads::crank_turns_fully(solution.linkage) ? "crank turns fully" : "";
  for (const auto& [is_so, remark] : {std::pair(solution.needs_reassembly, "needs re-assembly"),
                                      std::pair(solution.out_of_order, "out of order")})
    if (is_so) text += (text.empty() ? "" : ", ") + std::string(remark);
  return text;
}

std::string solution_line(const loads::PathSolution& solution, const UnitSystem units) {
  constexpr std::size_t dimensions = 9;
  const Entries row = entries_of(solution);
  std::string text;
  for (std::size_t i = 0; i < dimensions; ++i) text += fmt::format("{:>12}", shown(row[i], units));
  return text + "  " + remarks(solution) + "\n";
}

std::string table_of(const PathReport& report, const UnitSystem units) {
  const std::vector<loads::PathSolution>& solutions = report.synthesis.solutions;
  std::string text =
      fmt::format("four-bar linkages through {} points: {} found in {} starts\n",
                  report.task.points.size(), solutions.size(), report.synthesis.starts);
  if (solutions.empty()) return text;
  const OutputUnit length = output_unit(units, Dimension::length);
  for (const char* name : {"A x", "A y", "D x", "D y", "AB", "BC", "CD", "BP"})
    text += fmt::format("{:>12}", fmt::format("{} [{}]", name, length.name));
  text +=
      fmt::format("{:>12}\n", fmt::format("alpha [{}]", output_unit(units, Dimension::angle).name));
  double residual = 0.;
  for (const loads::PathSolution& solution : solutions)
    residual = std::max(residual, solution.residual);
  for (std::size_t i = 0; i < std::min(solutions.size(), most_solutions); ++i)
    text += solution_line(solutions[i], units);
  if (solutions.size() > most_solutions)
    text += fmt::format("and {} more in synthesis.csv\n", solutions.size() - most_solutions);
  return text + fmt::format("maximum residual of their equations: {:.2g} {}\n",
                            residual * length.factor, length.name);
}

}  // namespace

std::string synthesis_csv(const SynthesisReport& report, const UnitSystem units) {
  return std::visit([&](const auto& result) { return csv_of(result, units); }, report.result);
}

std::string synthesis_table(const SynthesisReport& report, const UnitSystem units) {
  return std::visit([&](const auto& result) { return table_of(result, units); }, report.result);
}

}  // namespace geneva::post
