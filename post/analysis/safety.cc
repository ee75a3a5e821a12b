#include "post/analysis/safety.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/analysis/material_limits.h"
#include "post/analysis/strength_rows.h"

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

/// A stress over the cycle as if it went with a power of the pin force: 1 as beams do, 1/2 as
/// Hertz's line contact.
CycleValue scaled(const double stress, const MechanismReport& mechanism, const double power) {
  const loads::PlacedPeak& force = mechanism.cycle_force;
  return {stress * std::pow(force.value / mechanism.load.force, power), force.driver_angle};
}

/// A stress over the cycle as the contact pressure goes: in 3-D not with the root of the force.
template <int dim>
CycleValue with_pressure(const double stress, const fem::Solution<dim>& solution,
                         const MechanismReport& mechanism) {
  if (!mechanism.pin) return scaled(stress, mechanism, 0.5);
  const double pressure = solution.contacts[leading_contact(solution)].peak_pressure;
  return {stress * mechanism.cycle_pressure.value / pressure,
          mechanism.cycle_pressure.driver_angle};
}

/// Of a pin of which only its section is modelled, and of a stud: of the greatest stress at its
/// root, by beam theory. Bending is greatest where shear is zero, and the other way round.
std::optional<SafetyRow> root_row(const MechanismReport& mechanism,
                                  const loads::Allowables& allowed) {
  const auto yield = allowed.yield_strengths.find(mechanism.roller ? "stud" : "pin");
  const bool is_modelled = mechanism.pin && !mechanism.roller;
  if (!mechanism.beam || is_modelled || yield == allowed.yield_strengths.end()) return std::nullopt;
  const loads::BeamBending& beam = *mechanism.beam;
  const double stress = std::max(beam.root_stress, std::sqrt(3.) * beam.root_shear);
  const std::string part = mechanism.roller ? "stud" : "pin";
  return SafetyRow{fmt::format("von Mises stress at the {}'s root (beam theory)", part),
                   Dimension::stress,
                   stress,
                   yield->second,
                   mechanism.load.driver_angle,
                   scaled(stress, mechanism, 1.),
                   fmt::format("below it the {} does not yield where the crank holds it", part)};
}

/// Limits of the peak contact pressure that follow from the materials of the bodies in contact.
template <int dim>
std::vector<SafetyRow> material_rows(const fem::Solution<dim>& solution,
                                     const fem::ContactResult<dim>& contact,
                                     const ContactAnalysis<dim>& analysis, const RunReport& report,
                                     const SafetyRow& pressure, const std::string& of,
                                     const double friction) {
  std::vector<SafetyRow> rows;
  for (const loads::MaterialLimit& limit :
       material_limits(solution, contact, analysis, report.allowed, friction)) {
    const bool is_of_flanks = limit.kind == loads::MaterialLimit::Kind::flanks;
    if (is_of_flanks && of != "contact") continue;
    rows.push_back(pressure);
    rows.back().quantity = of + ", " + limit.name;
    rows.back().allowed = limit.pressure;
    rows.back().meaning = limit.meaning;
  }
  return rows;
}

/// A named stress of a body that is away from the contact.
template <int dim>
std::optional<NamedStress<dim>> stress_away(const fem::Solution<dim>& solution,
                                            const std::string& body, const std::string& name) {
  for (const NamedStress<dim>& stress : named_stresses(solution))
    if (stress.body == body && stress.name == name && !stress.is_beside_contact) return stress;
  return std::nullopt;
}

/// Limits of the stresses of a body.
template <int dim>
std::vector<SafetyRow> strength_rows_of(const fem::Solution<dim>& solution,
                                        const Results<dim>& results, const RunReport& report,
                                        const std::size_t body) {
  std::vector<SafetyRow> rows;
  const std::string& name = solution.problem.bodies[body].name;
  const bool has_contact = fem::has_contact(solution.problem);
  const std::string where = has_contact ? " away from the contact" : "";
  const auto& mechanism = report.mechanism;
  const std::string over_cycle =
      mechanism ? "; over the cycle as if it went with the pin force" : "";
  // The power is that of the pin force with which it goes over the cycle.
  const auto add = [&](const std::string& quantity, const double stress, const bool is_finite,
                       const double limit, const double power, const std::string& meaning) {
    std::optional<CycleValue> cycle;
    if (mechanism && is_finite)
      cycle = power == 1. ? scaled(stress, *mechanism, power)
                          : with_pressure(stress, solution, *mechanism);
    rows.push_back({quantity, Dimension::stress, is_finite ? std::optional(stress) : std::nullopt,
                    limit, mechanism ? std::optional(mechanism->load.driver_angle) : std::nullopt,
                    cycle, meaning});
  };
  const auto& yields = report.allowed.yield_strengths;
  if (const auto yield = yields.find(name); yield != yields.end()) {
    const StressPeak<dim>& peak = results.max_von_mises[body];
    const bool in_layer = has_contact && is_in_layer(solution, results, report.allowed, body);
    if (has_contact)
      add("maximum von Mises stress of the " + name, peak.value, is_bounded(solution),
          in_layer ? report.allowed.layers.at(name).yield_strength : yield->second, 0.5,
          in_layer ? "below it the hardened layer yields nowhere"
                   : "below it the computed stress yields nowhere");
    if (const auto stress = stress_away(solution, name, "von Mises stress"))
      add("von Mises stress" + where + ", " + name, stress->maximum.value, stress->is_bounded,
          yield->second, 1., "below it nothing yields" + where + over_cycle);
  }
  const auto& fatigues = report.allowed.fatigue_strengths;
  const auto fatigue = fatigues.find(name);
  const auto tensile = stress_away(solution, name, "tensile stress");
  if (fatigue != fatigues.end() && tensile)
    add("tensile stress" + where + " (fatigue), " + name, tensile->maximum.value,
        tensile->is_bounded, fatigue->second, 1.,
        "below it the material bears any number of cycles" + where + over_cycle);
  return rows;
}

/// Limits of the pressure between needle and stud: of hardened raceways, and of the stud's
/// material.
std::vector<SafetyRow> needle_rows(const MechanismReport& mechanism,
                                   const loads::Allowables& allowed) {
  std::vector<SafetyRow> rows;
  const double pressure = mechanism.needle->pressure;
  const auto add = [&](const std::string& quantity, const double limit,
                       const std::string& meaning) {
    rows.push_back({quantity, Dimension::stress, pressure, limit, mechanism.load.driver_angle,
                    scaled(pressure, mechanism, 0.5), meaning});
  };
  for (const loads::NeedleLimit& limit : loads::needle_limits(allowed))
    add(limit.name, limit.pressure, limit.meaning);
  return rows;
}

/// Of gross sliding, the least favourable for what sticks and slips; of a mechanism at any instant.
template <int dim>
double friction_of_limits(const fem::Solution<dim>& solution, const std::size_t pair,
                          const std::optional<MechanismReport>& mechanism) {
  return mechanism ? mechanism->slot_friction : solution.problem.pairs[pair].friction.coefficient;
}

/// Limits of the pressure in a roller's bore; over the cycle it goes with the root of the force, as
/// Hertz's does.
template <int dim>
std::vector<SafetyRow> bore_rows(const fem::Solution<dim>& solution, const Results<dim>& results,
                                 const RunReport& report) {
  if (!report.mechanism || !report.mechanism->roller) return {};
  const loads::PinLoad& load = report.mechanism->load;
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    const fem::ContactResult<dim>& bore = solution.contacts[i];
    if (bore.source != "stud") continue;
    const SafetyRow pressure{
        "", Dimension::stress, bore.peak_pressure,
        0., load.driver_angle, scaled(bore.peak_pressure, *report.mechanism, 0.5),
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
                       of_pressure, "contact", friction_of_limits(solution, leading, mechanism)))
      rows.push_back(row);
  for (const SafetyRow& row : bore_rows(solution, results, report)) rows.push_back(row);
  if (mechanism && mechanism->needle)
    for (const SafetyRow& row : needle_rows(*mechanism, allowed)) rows.push_back(row);
  if (allowed.pressure_times_slip && mechanism && !mechanism->needle) {
    const loads::PinLoad& load = mechanism->load;
    rows.push_back({mechanism->roller ? "mean bore pressure times sliding speed"
                                      : "peak contact pressure times slip speed",
                    Dimension::pressure_times_speed,
                    mechanism->roller ? std::optional(mechanism->bore_pressure * load.bore_speed)
                                      : if_bounded(pressure * std::abs(load.slip_speed)),
                    *allowed.pressure_times_slip, analysed, of_cycle(mechanism->cycle_wear), ""});
  }
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i)
    for (const SafetyRow& row : strength_rows_of(solution, results, report, i)) rows.push_back(row);
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
