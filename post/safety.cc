#include "post/safety.h"

#include <fmt/format.h>

#include <cmath>

namespace geneva::post {

template <int dim>
std::vector<SafetyRow> safety(const fem::Solution<dim>& solution, const Results<dim>& results,
                              const RunReport& report) {
  const bool is_bounded = (!solution.edge || solution.edge->is_bounded) &&
                          solution.outcome != fem::Outcome::unbounded_pressure;
  const auto if_bounded = [&](const double value) {
    return is_bounded ? std::optional(value) : std::nullopt;
  };
  const double pressure = solution.contacts[leading_contact(solution)].peak_pressure;
  const Allowables& allowed = report.allowed;
  std::vector<SafetyRow> rows;
  if (allowed.contact_pressure)
    rows.push_back({"peak contact pressure", Dimension::stress, if_bounded(pressure),
                    *allowed.contact_pressure});
  if (allowed.pressure_times_slip && report.mechanism)
    rows.push_back({"peak contact pressure times slip speed", Dimension::pressure_times_speed,
                    if_bounded(pressure * std::abs(report.mechanism->load.slip_speed)),
                    *allowed.pressure_times_slip});
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i) {
    const std::string& body = solution.problem.bodies[i].name;
    const auto yield = allowed.yield_strengths.find(body);
    if (yield != allowed.yield_strengths.end())
      rows.push_back({"greatest von Mises stress of the " + body, Dimension::stress,
                      if_bounded(results.max_von_mises[i].value), yield->second});
  }
  return rows;
}

std::string safety_lines(const std::vector<SafetyRow>& rows, const UnitSystem units) {
  std::string text;
  for (const SafetyRow& row : rows) {
    const OutputUnit unit = output_unit(units, row.dimension);
    if (row.computed)
      text += fmt::format("{}: {:.5g} of {:.5g} {} allowed, safety factor {:.3g}\n", row.quantity,
                          *row.computed * unit.factor, row.allowed * unit.factor, unit.name,
                          *row.factor());
    else
      text += fmt::format("{}: not bounded, so that {:.5g} {} cannot be kept\n", row.quantity,
                          row.allowed * unit.factor, unit.name);
  }
  return text;
}

template std::vector<SafetyRow> safety(const fem::Solution<2>&, const Results<2>&,
                                       const RunReport&);
template std::vector<SafetyRow> safety(const fem::Solution<3>&, const Results<3>&,
                                       const RunReport&);

}  // namespace geneva::post
