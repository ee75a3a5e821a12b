#include "api/mechanism_results.h"

#include <cmath>

#include "api/engagement.h"
#include "api/mechanism_picture.h"
#include "api/pin_results.h"
#include "model/pin_in_space.h"

namespace geneva::api {

using post::Figure;

namespace {

double about_z(const double moment) { return moment; }
double about_z(const dealii::Tensor<1, 3>& moment) { return moment[2]; }

/// Of how many equal parts the model is one.
double parts(const model::MechanismCase& mechanism, const int dim) {
  return dim == 3 && model::is_half_model(mechanism) ? 2. : 1.;
}

std::optional<loads::BeamBending> pin_beam_bending(const model::MechanismCase& mechanism,
                                                   const model::MechanismState& state) {
  const auto beam = model::pin_beam(mechanism, state.sizes);
  if (!beam) return std::nullopt;
  return loads::beam_bending(*beam, state.load.force);
}

/// On either wall.
loads::PlacedPeak greatest_force(const loads::Characteristics& cycle) {
  return cycle.braking_force.value > cycle.force.value ? cycle.braking_force : cycle.force;
}

/// The computed peak pressure where it is greatest over the cycle: as that of line contacts goes,
/// where these know none with the root of the force.
loads::PlacedPeak pressure_over_cycle(const double peak, const model::MechanismState& state,
                                      const loads::Characteristics& cycle,
                                      const std::optional<LinePressures>& line) {
  loads::PlacedPeak greatest = line ? line->of_cycle : greatest_force(cycle);
  greatest.value = line ? peak * line->of_cycle.value / line->analysed
                        : peak * std::sqrt(greatest.value / state.load.force);
  return greatest;
}

}  // namespace

template <int dim>
std::optional<double> bore_torque(const model::Model<dim>& model,
                                  const model::MechanismCase& mechanism,
                                  const fem::Solution<dim>& solution) {
  if (!model.mechanism->wheel || mechanism.is_local) return std::nullopt;
  for (const fem::Reaction<dim>& reaction : solution.reactions)
    if (reaction.surface == model.held_surface)
      return -parts(mechanism, dim) * about_z(reaction.moment);
  return std::nullopt;
}

std::optional<post::NeedleReport> needle_report(const model::MechanismCase& mechanism,
                                                const double force) {
  if (!mechanism.roller || !mechanism.roller->needles) return std::nullopt;
  const loads::NeedleBearing& needles = *mechanism.roller->needles;
  const double load = std::abs(force);
  return post::NeedleReport{
      loads::greatest_needle_load(needles, load),
      loads::needle_pressure(needles, mechanism.roller->diameter, load,
                             {mechanism.stud.youngs_modulus, mechanism.stud.poissons_ratio})};
}

template <int dim>
std::optional<post::MechanismReport> mechanism_report(
    const model::Model<dim>& model, const model::Case& given, const fem::Solution<dim>& solution,
    [[maybe_unused]] const post::Results<dim>& results) {
  if (!model.mechanism) return std::nullopt;
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState& state = *model.mechanism;
  const loads::PinContact contact = pin_contact(mechanism, state.sizes);
  const loads::Characteristics cycle = loads::characteristics(state.driven, state.train, contact);
  post::MechanismReport report{
      state.load,
      state.inertia_from_geometry,
      state.train.wheel_inertia,
      state.expected_bore_torque,
      model.held_surface,
      bore_torque(model, mechanism, solution),
      pin_beam_bending(mechanism, state),
      std::nullopt,
      parts(mechanism, dim),
      state.train.roller,
      loads::bore_pressure(contact, state.train, state.load.force),
      needle_report(mechanism, state.load.force),
      state.train.slot_friction,
      greatest_force(cycle),
      cycle.pressure,
      state.train.roller ? cycle.bore_pressure_times_speed : cycle.pressure_times_slip};
  if constexpr (dim == 3) {
    report.pin = pin_report(mechanism, state, solution, results.cells);
    const double peak = solution.contacts[post::leading_contact(solution)].peak_pressure;
    report.cycle_pressure =
        pressure_over_cycle(peak, state, cycle, line_pressures(mechanism, state, cycle));
    if (!state.train.roller)
      report.cycle_wear.value *= report.cycle_pressure.value / cycle.pressure.value;
  }
  return report;
}

template <int dim>
post::RunFigures run_figures(const model::Model<dim>& model, const model::Case& given,
                             const fem::Solution<dim>& solution) {
  const std::vector<post::CellStress<dim>> cells = post::cell_stresses(solution);
  post::RunFigures figures = post::contact_figures(solution, cells);
  if (!model.mechanism) return figures;
  if (const auto torque = bore_torque(model, *given.mechanism, solution))
    figures.mechanism[Figure::bore_torque] = *torque;
  if constexpr (dim == 3)
    if (const auto bending = bending_of_pin(*given.mechanism, *model.mechanism, solution, cells)) {
      figures.mechanism[Figure::tip_deflection] = bending->tip_deflection;
      figures.mechanism[Figure::slope] = bending->slope;
      figures.mechanism[Figure::root_stress] = bending->root_stress;
      figures.mechanism[Figure::section_moment] = bending->section_moment;
    }
  return figures;
}

template std::optional<post::MechanismReport> mechanism_report(const model::Model<2>&,
                                                               const model::Case&,
                                                               const fem::Solution<2>&,
                                                               const post::Results<2>&);
template std::optional<post::MechanismReport> mechanism_report(const model::Model<3>&,
                                                               const model::Case&,
                                                               const fem::Solution<3>&,
                                                               const post::Results<3>&);
template std::optional<double> bore_torque(const model::Model<2>&, const model::MechanismCase&,
                                           const fem::Solution<2>&);
template std::optional<double> bore_torque(const model::Model<3>&, const model::MechanismCase&,
                                           const fem::Solution<3>&);
template post::RunFigures run_figures(const model::Model<2>&, const model::Case&,
                                      const fem::Solution<2>&);
template post::RunFigures run_figures(const model::Model<3>&, const model::Case&,
                                      const fem::Solution<3>&);

}  // namespace geneva::api
