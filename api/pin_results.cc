#include "api/pin_results.h"

#include <algorithm>
#include <cstddef>

#include "model/input/parameters.h"

namespace geneva::api {

namespace {

const char* name_of(const model::PinCase::Profile profile) {
  using Profile = model::PinCase::Profile;
  switch (profile) {
    case Profile::crown:
      return model::names::crown;
    case Profile::logarithmic:
      return model::names::logarithmic;
    case Profile::table:
      return model::names::table;
    case Profile::cylindrical:
      break;
  }
  return model::names::cylindrical;
}

}  // namespace

std::optional<post::PinBending> bending_of_pin(const model::MechanismCase& mechanism,
                                               const model::MechanismState& state,
                                               const fem::Solution<3>& solution,
                                               const std::vector<post::CellStress<3>>& cells) {
  using Hold = model::PinHolding::Hold;
  const Hold hold = mechanism.pin_holding.hold;
  if (hold == Hold::core) return std::nullopt;
  const loads::PinClearance clearance = model::pin_clearance(mechanism, state);
  const auto face = std::find_if(
      solution.mesh.faces.begin(), solution.mesh.faces.end(), [&](const mesh::Face<3>& candidate) {
        return solution.mesh.surfaces[candidate.surface] == "pin" && candidate.circle >= 0;
      });
  const mesh::Circle& circle = solution.mesh.circles[static_cast<std::size_t>(face->circle)];
  const bool held_twice = hold == Hold::both_ends;
  return post::pin_bending(solution,
                           {"pin",
                            circle.centre[0],
                            circle.centre[1],
                            state.sizes.pin_diameter,
                            held_twice ? 0. : clearance.lower_end,
                            0.,
                            clearance.upper_end,
                            model::pin_lengths(mechanism, state.sizes).root_gap,
                            model::pin_holder(mechanism),
                            held_twice,
                            model::is_half_model(mechanism),
                            {0., 1., 0.}},
                           cells);
}

post::PinReport pin_report(const model::MechanismCase& mechanism,
                           const model::MechanismState& state, const fem::Solution<3>& solution,
                           const std::vector<post::CellStress<3>>& cells) {
  const loads::PinClearance clearance = model::pin_clearance(mechanism, state);
  post::PinReport report{};
  report.profile = name_of(mechanism.space->profile);
  if (const auto* crown = std::get_if<loads::Crown>(&clearance.profile))
    report.crown_radius = crown->radius;
  if (const auto* profile = std::get_if<loads::LogarithmicProfile>(&clearance.profile))
    report.amplitude = profile->amplitude;
  if (const auto known = model::pin_line_contact(mechanism, state))
    report.line = {known->pin, known->contact, loads::peak_doubt(known->pin, known->contact)};
  if (const auto bending = bending_of_pin(mechanism, state, solution, cells))
    report.bending = *bending;
  return report;
}

}  // namespace geneva::api
