#include "post/analysis/safety.h"

#include <fmt/format.h>

#include <cmath>

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

bool SafetyRow::is_worse_elsewhere() const { return cycle && computed && cycle->value > *computed; }

std::optional<double> SafetyRow::computed_factor() const {
  return computed ? std::optional(allowed / *computed) : std::nullopt;
}

std::optional<double> SafetyRow::factor() const {
  return is_worse_elsewhere() ? allowed / cycle->value : computed_factor();
}

std::optional<double> SafetyRow::driver_angle() const {
  return is_worse_elsewhere() ? cycle->driver_angle : analysed_angle;
}

template <int dim>
std::vector<SafetyRow> safety(const fem::Solution<dim>& solution, const Results<dim>& results,
                              const RunReport& report) {
  const auto if_bounded = [&](const double value) {
    return is_bounded(solution) ? std::optional(value) : std::nullopt;
  };
  const bool has_contact = fem::has_contact(solution.problem);
  const double pressure =
      has_contact ? solution.contacts[leading_contact(solution)].peak_pressure : 0.;
  const loads::Allowables& allowed = report.allowed;
  const auto& mechanism = report.mechanism;
  const std::optional<double> analysed =
      mechanism ? std::optional(mechanism->load.driver_angle) : std::nullopt;
  const auto of_cycle = [](const loads::PlacedPeak& peak) {
    return CycleValue{peak.value, peak.driver_angle};
  };
  std::vector<SafetyRow> rows;
  if (allowed.contact_pressure)
    rows.push_back({"peak contact pressure", Dimension::stress, if_bounded(pressure),
                    *allowed.contact_pressure, analysed,
                    mechanism ? std::optional(of_cycle(mechanism->cycle_pressure)) : std::nullopt});
  if (allowed.pressure_times_slip && mechanism) {
    const loads::PinLoad& load = mechanism->load;
    rows.push_back({mechanism->roller ? "mean bore pressure times sliding speed"
                                      : "peak contact pressure times slip speed",
                    Dimension::pressure_times_speed,
                    mechanism->roller ? std::optional(mechanism->bore_pressure * load.bore_speed)
                                      : if_bounded(pressure * std::abs(load.slip_speed)),
                    *allowed.pressure_times_slip, analysed, of_cycle(mechanism->cycle_wear)});
  }
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i) {
    const std::string& body = solution.problem.bodies[i].name;
    const fem::BodyStrength<dim>& strength = solution.strength[i];
    const std::string where = has_contact ? " away from the contact" : "";
    const auto add = [&](const std::string& quantity, const std::optional<double> computed,
                         const double limit) {
      rows.push_back({quantity, Dimension::stress, computed, limit, analysed, std::nullopt});
    };
    if (const auto yield = allowed.yield_strengths.find(body);
        yield != allowed.yield_strengths.end()) {
      if (has_contact)
        add("maximum von Mises stress of the " + body, if_bounded(results.max_von_mises[i].value),
            yield->second);
      if (strength.von_mises.value > 0.)
        add("von Mises stress" + where + ", " + body, strength.von_mises.value, yield->second);
    }
    if (const auto fatigue = allowed.fatigue_strengths.find(body);
        fatigue != allowed.fatigue_strengths.end() && strength.tensile.value > 0.)
      add("tensile stress" + where + " (fatigue), " + body, strength.tensile.value,
          fatigue->second);
  }
  return rows;
}

std::string safety_lines(const std::vector<SafetyRow>& rows, const UnitSystem units) {
  const OutputUnit angle = output_unit(units, Dimension::angle);
  std::string text;
  for (const SafetyRow& row : rows) {
    const OutputUnit unit = output_unit(units, row.dimension);
    if (!row.factor()) {
      text += fmt::format("{}: not bounded, so that {:.5g} {} cannot be kept\n", row.quantity,
                          row.allowed * unit.factor, unit.name);
      continue;
    }
    text += fmt::format("{}: {:.5g} of {:.5g} {} allowed, safety factor {:.3g}", row.quantity,
                        row.allowed / *row.factor() * unit.factor, row.allowed * unit.factor,
                        unit.name, *row.factor());
    if (row.cycle)
      text += fmt::format(" at {:.5g} {} (as analysed at {:.5g} {}: {:.5g}, {:.3g})",
                          *row.driver_angle() * angle.factor, angle.name,
                          *row.analysed_angle * angle.factor, angle.name,
                          *row.computed * unit.factor, *row.computed_factor());
    text += '\n';
  }
  return text;
}

template std::vector<SafetyRow> safety(const fem::Solution<2>&, const Results<2>&,
                                       const RunReport&);
template std::vector<SafetyRow> safety(const fem::Solution<3>&, const Results<3>&,
                                       const RunReport&);

}  // namespace geneva::post
