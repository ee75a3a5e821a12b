#include "api/design_strength.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "api/analysis.h"
#include "api/analysis_state.h"
#include "api/told_together.h"
#include "base/errors.h"
#include "post/analysis/strength_rows.h"

namespace geneva {

namespace {

constexpr int steps_on_either_side = 4;  // of the best diameter
constexpr double step_ratio = 1.147;

/// The case with a wheel of another diameter, as far as its arms count.
Case resized_case(const Case& given, const double diameter) {
  constexpr double contact_accuracy = 0.02;
  constexpr double structural_accuracy = 0.02;
  Case result = given;
  model::MechanismCase mechanism = designed_mechanism(given);
  mechanism.dimensions =
      loads::resized(mechanism.dimensions, mechanism.design.given_lengths, diameter);
  mechanism.is_local = false;
  mechanism.space.reset();
  mechanism.inertia_kind = model::MechanismCase::InertiaKind::from_geometry;
  result.mechanism = mechanism;
  result.dimension = 2;
  result.settings.accuracy = contact_accuracy;
  result.settings.structural_accuracy =
      given.settings.structural_accuracy.value_or(structural_accuracy);
  return result;
}

post::WheelStrength strength_of(const Analysis& analysis, const double diameter) {
  const auto& solved = std::get<api::AnalysedModel<2>>(analysis.state->analysed);
  post::WheelStrength result{};
  result.diameter = diameter;
  result.peak_pressure = analysis.contacts.front().peak_pressure;
  result.peak_pressure_error = analysis.error;
  for (const post::NamedStress<2>& stress : post::named_stresses(solved.solution)) {
    if (stress.body != "wheel") continue;
    if (stress.name == "tensile stress") {
      result.tensile = stress.maximum.value;
      result.tensile_error = stress.maximum.total_error();
      result.where = stress.where;
    } else {
      result.von_mises = stress.maximum.value;
      result.von_mises_error = stress.maximum.total_error();
    }
  }
  return result;
}

/// Equal ratios on either side of the best wheel, and the best one as drawn; ascending.
std::vector<double> diameters_around(const double best, const double best_drawn) {
  constexpr double same = 1e-3;
  std::vector<double> diameters;
  for (int step = -steps_on_either_side; step <= steps_on_either_side; ++step)
    diameters.push_back(best * std::pow(step_ratio, step));
  if (std::abs(best_drawn / best - 1.) > same) diameters.push_back(best_drawn);
  std::sort(diameters.begin(), diameters.end());
  return diameters;
}

/// Adds the stresses of a wheel of that diameter, or a notice on why there is none.
void add_wheel(Design& design, const double diameter, const MPI_Comm communicator,
               mesh::Mesher* const mesher) {
  try {
    AnalysisOptions options;
    options.mesher = mesher;
    design.report.strength.push_back(strength_of(
        analyse(resized_case(design.given, diameter), communicator, options), diameter));
  } catch (const base::InputError& error) {
    const base::OutputUnit unit = base::output_unit(design.given.units, base::Dimension::length);
    design.notices.push_back(fmt::format("no wheel of diameter {:.5g} {}: {}",
                                         diameter * unit.factor, unit.name, error.what()));
  }
}

}  // namespace

void add_strength(Design& design, const MPI_Comm communicator, mesh::Mesher* const mesher,
                  const std::function<void(int, int)>& tell) {
  const double best = design.report.johnson.value_or(design.report.drawn.wheel).diameter;
  const std::vector<double> diameters = diameters_around(best, design.report.drawn.wheel.diameter);
  for (std::size_t wheel = 0; wheel < diameters.size(); ++wheel) {
    add_wheel(design, diameters[wheel], communicator, mesher);
    if (tell)
      end_together(communicator,
                   [&] { tell(static_cast<int>(wheel) + 1, static_cast<int>(diameters.size())); });
  }
  if (!design.report.strength.empty()) return;
  analyse(resized_case(design.given, best), communicator);  // says why there is none
}

}  // namespace geneva
