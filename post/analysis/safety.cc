#include "post/analysis/safety.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loads/contact_limits.h"
#include "post/analysis/surface_body.h"

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

namespace {

/// Of a pin of which only its section is modelled: of the greatest stress at its root, by beam
/// theory. Bending is greatest where shear is zero, and the other way round.
std::optional<SafetyRow> root_row(const MechanismReport& mechanism,
                                  const loads::Allowables& allowed) {
  const auto yield = allowed.yield_strengths.find(mechanism.roller ? "stud" : "pin");
  if (!mechanism.beam || mechanism.pin || yield == allowed.yield_strengths.end())
    return std::nullopt;
  const loads::BeamBending& beam = *mechanism.beam;
  const double stress = std::max(beam.root_stress, std::sqrt(3.) * beam.root_shear);
  const loads::PlacedPeak& force = mechanism.cycle_force;
  const std::string part = mechanism.roller ? "stud" : "pin";
  return SafetyRow{fmt::format("von Mises stress at the {}'s root (beam theory)", part),
                   Dimension::stress,
                   stress,
                   yield->second,
                   mechanism.load.driver_angle,
                   CycleValue{stress * force.value / mechanism.load.force, force.driver_angle},
                   fmt::format("below it the {} does not yield where the crank holds it", part)};
}

/// Whether the leading contact is a line or a circle, by Hertz; nothing of others.
std::optional<bool> is_line_contact(const ContactAnalysis<2>& analysis) {
  if (!analysis.hertz) return std::nullopt;
  return analysis.hertz->line.has_value();
}
std::optional<bool> is_line_contact(const ContactAnalysis<3>& analysis) {
  if (!analysis.hertz || !analysis.hertz->line) return std::nullopt;
  return true;
}

/// Limits of the peak contact pressure that follow from the materials of the bodies in contact.
template <int dim>
std::vector<SafetyRow> material_rows(const fem::Solution<dim>& solution,
                                     const fem::ContactResult<dim>& contact,
                                     const ContactAnalysis<dim>& analysis, const RunReport& report,
                                     const SafetyRow& pressure, const std::string& of,
                                     const double friction) {
  std::vector<SafetyRow> rows;
  const auto add = [&](const std::string& name, const double allowed, const std::string& meaning) {
    rows.push_back(pressure);
    rows.back().quantity = name;
    rows.back().allowed = allowed;
    rows.back().meaning = meaning;
  };
  const std::optional<bool> is_line = is_line_contact(analysis);
  const std::set<unsigned int> touching{body_of(solution, contact.source),
                                        body_of(solution, contact.target)};
  for (const unsigned int touched : touching) {
    const fem::Body<dim>& body = solution.problem.bodies[touched];
    const auto yield = report.allowed.yield_strengths.find(body.name);
    if (is_line && yield != report.allowed.yield_strengths.end()) {
      const double nu = body.material.poissons_ratio;
      const loads::ContactLimits limits =
          *is_line ? loads::line_contact_limits(nu, friction) : loads::point_contact_limits(nu);
      add(of + ", first yield, " + body.name, limits.first_yield * yield->second,
          "below it no point of the material yields");
      add(of + ", shakedown, " + body.name, limits.shakedown * yield->second,
          "below it the material yields at first and is elastic again under any number of passes");
    }
    if (const auto flank = report.allowed.flank_pressures.find(body.name);
        of == "contact" && flank != report.allowed.flank_pressures.end())
      add("contact, as gear flanks, " + body.name, flank->second,
          "below it the flanks of gears of this material bear any number of passes without pits");
  }
  return rows;
}

/// Limits of the pressure in a roller's bore; over the cycle it goes with the root of the force, as
/// Hertz's does.
template <int dim>
std::vector<SafetyRow> bore_rows(const fem::Solution<dim>& solution, const Results<dim>& results,
                                 const RunReport& report) {
  if (!report.mechanism || !report.mechanism->roller) return {};
  const loads::PinLoad& load = report.mechanism->load;
  const loads::PlacedPeak& greatest = report.mechanism->cycle_force;
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    const fem::ContactResult<dim>& bore = solution.contacts[i];
    constexpr double most = 1.;  // of the closed form
    if (bore.source != "stud" || report.mechanism->roller->friction > most) continue;
    const SafetyRow pressure{"",
                             Dimension::stress,
                             bore.peak_pressure,
                             0.,
                             load.driver_angle,
                             CycleValue{bore.peak_pressure * std::sqrt(greatest.value / load.force),
                                        greatest.driver_angle},
                             ""};
    return material_rows(solution, bore, results.contacts[i], report, pressure, "roller bore",
                         report.mechanism->roller->friction);
  }
  return {};
}

}  // namespace

template <int dim>
std::vector<SafetyRow> safety(const fem::Solution<dim>& solution, const Results<dim>& results,
                              const RunReport& report) {
  const auto if_bounded = [&](const double value) {
    return is_bounded(solution) ? std::optional(value) : std::nullopt;
  };
  const bool has_contact = fem::has_contact(solution.problem);
  const std::size_t leading = has_contact ? leading_contact(solution) : 0;
  const double pressure = has_contact ? solution.contacts[leading].peak_pressure : 0.;
  const loads::Allowables& allowed = report.allowed;
  const auto& mechanism = report.mechanism;
  const std::optional<double> analysed =
      mechanism ? std::optional(mechanism->load.driver_angle) : std::nullopt;
  const auto of_cycle = [](const loads::PlacedPeak& peak) {
    return CycleValue{peak.value, peak.driver_angle};
  };
  const SafetyRow of_pressure{
      "peak contact pressure",
      Dimension::stress,
      if_bounded(pressure),
      allowed.contact_pressure.value_or(0.),
      analysed,
      mechanism ? std::optional(of_cycle(mechanism->cycle_pressure)) : std::nullopt,
      ""};
  std::vector<SafetyRow> rows;
  if (allowed.contact_pressure) rows.push_back(of_pressure);
  if (has_contact)
    for (const SafetyRow& row :
         material_rows(solution, solution.contacts[leading], results.contacts[leading], report,
                       of_pressure, "contact", mechanism ? mechanism->slot_friction : 0.))
      rows.push_back(row);
  for (const SafetyRow& row : bore_rows(solution, results, report)) rows.push_back(row);
  if (allowed.pressure_times_slip && mechanism) {
    const loads::PinLoad& load = mechanism->load;
    rows.push_back({mechanism->roller ? "mean bore pressure times sliding speed"
                                      : "peak contact pressure times slip speed",
                    Dimension::pressure_times_speed,
                    mechanism->roller ? std::optional(mechanism->bore_pressure * load.bore_speed)
                                      : if_bounded(pressure * std::abs(load.slip_speed)),
                    *allowed.pressure_times_slip, analysed, of_cycle(mechanism->cycle_wear), ""});
  }
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i) {
    const std::string& body = solution.problem.bodies[i].name;
    const fem::BodyStrength<dim>& strength = solution.strength[i];
    const std::string where = has_contact ? " away from the contact" : "";
    const auto add = [&](const std::string& quantity, const std::optional<double> computed,
                         const double limit) {
      rows.push_back({quantity, Dimension::stress, computed, limit, analysed, std::nullopt, ""});
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
  if (const auto root = mechanism ? root_row(*mechanism, allowed) : std::nullopt)
    rows.push_back(*root);
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
    text += fmt::format("{}: {:.5g} of {:.5g} {} allowed, safety factor {:.3g}{}", row.quantity,
                        row.allowed / *row.factor() * unit.factor, row.allowed * unit.factor,
                        unit.name, *row.factor(), *row.factor() < 1. ? ", EXCEEDED" : "");
    constexpr double worth_saying = 0.005;
    const bool is_worst =
        row.computed && row.cycle && std::abs(row.cycle->value / *row.computed - 1.) < worth_saying;
    if (is_worst)
      text += fmt::format(" at {:.5g} {}", *row.driver_angle() * angle.factor, angle.name);
    else if (row.cycle)
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
