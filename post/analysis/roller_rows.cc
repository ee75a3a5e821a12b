#include "post/analysis/roller_rows.h"

#include <algorithm>

namespace geneva::post {

using base::Dimension;

namespace {

/// What the closed forms know of the bore: its mean pressure, or its most loaded needle.
std::vector<ComparisonRow> bearing_rows(const RunReport& report) {
  if (!report.mechanism || !report.mechanism->roller) return {};
  if (const auto& needle = report.mechanism->needle)
    return {{"load of the most loaded needle", Dimension::force, std::nullopt, std::nullopt, true,
             needle->load, std::nullopt},
            {"peak pressure, needle on stud", Dimension::stress, std::nullopt, std::nullopt, true,
             needle->pressure, std::nullopt}};
  return {{"mean pressure, roller bore", Dimension::stress, std::nullopt, std::nullopt, true,
           report.mechanism->bore_pressure, std::nullopt}};
}

}  // namespace

std::vector<ComparisonRow> roller_rows(const fem::Solution<2>& solution, const Results<2>& results,
                                       const RunReport& report) {
  std::vector<ComparisonRow> rows = bearing_rows(report);
  if (rows.empty()) return rows;
  const auto bore =
      std::find_if(solution.contacts.begin(), solution.contacts.end(),
                   [](const fem::ContactResult<2>& one) { return one.source == "stud"; });
  if (bore == solution.contacts.end()) return rows;
  const auto place = static_cast<std::size_t>(bore - solution.contacts.begin());
  const auto& hertz = results.contacts[place].hertz;
  const double radius = solution.mesh.circles[static_cast<std::size_t>(bore->target_circle)].radius;
  const auto closed = [&](const double value) {
    return hertz ? std::optional(value) : std::nullopt;
  };
  rows.push_back({"peak pressure, roller bore", Dimension::stress, bore->peak_pressure,
                  solution.error_estimate, true, closed(hertz ? hertz->peak_pressure() : 0.),
                  std::nullopt});
  rows.push_back({"contact angle, roller bore", Dimension::angle, 2. * bore->half_width / radius,
                  value_of(report.errors.contacts[place], Figure::half_width), true,
                  closed(hertz ? 2. * hertz->half_width() / radius : 0.), std::nullopt});
  return rows;
}

std::vector<ComparisonRow> roller_rows(const fem::Solution<3>& /*solution*/,
                                       const Results<3>& /*results*/, const RunReport& report) {
  return bearing_rows(report);
}

}  // namespace geneva::post
