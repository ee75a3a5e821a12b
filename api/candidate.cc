#include "api/candidate.h"

#include <algorithm>

#include "api/engagement.h"
#include "api/mechanism_picture.h"
#include "base/errors.h"
#include "loads/motion/kinematics.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/least_wall.h"
#include "model/mechanism_state.h"
#include "model/pin_in_space.h"

namespace geneva::api {

namespace {

using base::Dimension;
using Bound = LimitedFigure::Bound;

/// A wall that is thinner is neither milled nor hardened.
constexpr double wall_per_slot_width = 0.1;

loads::Outline drawing_of(const loads::GenevaDimensions& wheel) {
  return loads::wheel_outline(wheel);
}

loads::Outline drawing_of(const loads::InternalDimensions& wheel) {
  return loads::internal_wheel_outline(wheel);
}

void add_wheel(Candidate& candidate, const model::DrawnWheel& drawn, const double density) {
  std::visit(
      [&](const auto& wheel) {
        candidate.mass = density * wheel.thickness * loads::area_moments(drawing_of(wheel)).area;
        candidate.least_wall = loads::least_wall(wheel);
        candidate.least_wall_rule = wall_per_slot_width * wheel.slot_width;
      },
      drawn);
}

}  // namespace

PressureBasis pressure_basis(const Case& given) {
  const model::MechanismCase& mechanism = *given.mechanism;
  if (!mechanism.space) return PressureBasis::even_load;
  try {
    candidate_of(given, PressureBasis::line_contacts);
    return PressureBasis::line_contacts;
  } catch (const base::InputError&) {
    return PressureBasis::even_load;
  }
}

Candidate candidate_of(const Case& given, const PressureBasis basis) {
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState state = model::mechanism_state(mechanism);
  const loads::PinContact contact = pin_contact(mechanism, state.sizes);
  const loads::Characteristics cycle = loads::characteristics(state.driven, state.train, contact);
  Candidate candidate{};
  candidate.pressure = loads::hertz_pressure(contact, state.load.force);
  candidate.pressure_of_cycle = cycle.pressure.value;
  if (basis == PressureBasis::line_contacts) {
    const auto line = line_pressures(mechanism, state, cycle);
    if (!line)
      throw base::InputError(
          "line contacts along the pin know no peak pressure, mostly because the contact reaches "
          "the wall's edge ('geneva estimate' says why)");
    candidate.pressure = line->analysed;
    candidate.pressure_of_cycle = line->of_cycle.value;
  }
  if (state.wheel) add_wheel(candidate, *state.wheel, mechanism.wheel.density);
  if (const auto beam = model::pin_beam(mechanism, state.sizes))
    candidate.root_stress =
        loads::beam_bending(*beam, std::max(cycle.force.value, cycle.braking_force.value))
            .root_stress;
  return candidate;
}

const char* name_of(const OptimisationGoal goal) {
  switch (goal) {
    case OptimisationGoal::pressure:
      return model::names::peak_pressure;
    case OptimisationGoal::mass:
      return model::names::wheel_mass;
    case OptimisationGoal::slot_bottom:
      return model::names::slot_bottom;
    case OptimisationGoal::pressure_of_cycle:
      break;
  }
  return model::names::peak_pressure_of_cycle;
}

std::optional<double> value_of(const Candidate& candidate, const OptimisationGoal goal) {
  switch (goal) {
    case OptimisationGoal::pressure:
      return candidate.pressure;
    case OptimisationGoal::mass:
      return candidate.mass;
    case OptimisationGoal::slot_bottom:
      return candidate.slot_bottom;
    case OptimisationGoal::pressure_of_cycle:
      break;
  }
  return candidate.pressure_of_cycle;
}

double LimitedFigure::excess() const {
  if (!limit) return 0.;
  if (!value) return 1.;
  return bound == Bound::greatest ? *value / *limit - 1. : 1. - *value / *limit;
}

std::vector<LimitedFigure> limited_figures(const model::OptimisationCase& wanted,
                                           const Candidate& candidate) {
  const auto& wall = candidate.least_wall;
  return {{name_of(OptimisationGoal::pressure_of_cycle),
           Dimension::stress,
           candidate.pressure_of_cycle,
           wanted.largest_pressure,
           Bound::greatest,
           {}},
          {name_of(OptimisationGoal::mass),
           Dimension::mass,
           candidate.mass,
           wanted.largest_mass,
           Bound::greatest,
           {}},
          {"least wall of the wheel", Dimension::length,
           wall ? std::optional(wall->thickness) : std::nullopt,
           wanted.least_wall ? wanted.least_wall : candidate.least_wall_rule, Bound::least,
           wall ? wall->between : ""},
          {"bending stress at the pin root",
           Dimension::stress,
           candidate.root_stress,
           wanted.largest_root_stress,
           Bound::greatest,
           {}},
          {name_of(OptimisationGoal::slot_bottom),
           Dimension::stress,
           candidate.slot_bottom,
           wanted.largest_slot_bottom,
           Bound::greatest,
           {}}};
}

}  // namespace geneva::api
