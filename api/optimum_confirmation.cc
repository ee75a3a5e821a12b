#include "api/optimum_confirmation.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "api/analysis.h"
#include "api/analysis_state.h"
#include "base/errors.h"
#include "post/analysis/strength_rows.h"

namespace geneva {

namespace {

/// A stress and its relative error.
struct Stress {
  double value;
  double error;
};

template <int dim>
std::optional<Stress> tensile_stress(const fem::Solution<dim>& solution) {
  for (const post::NamedStress<dim>& stress : post::named_stresses(solution))
    if (stress.body == "wheel" && stress.name == "tensile stress")
      return Stress{stress.maximum.value, stress.maximum.total_error()};
  return std::nullopt;
}

std::optional<Stress> tensile_stress(const Analysis& analysis) {
  return std::visit([](const auto& solved) { return tensile_stress(solved.solution); },
                    analysis.state->analysed);
}

/// The greatest pressure of the cycle as the run's goes, which is that of one instant.
void confirm_cycle(std::vector<post::OptimumFigure>& figures) {
  const post::OptimumFigure& at_instant = figures.front();
  const std::string name = model::names::peak_pressure_of_cycle;
  const auto of_cycle =
      std::find_if(figures.begin(), figures.end(),
                   [&](const post::OptimumFigure& figure) { return figure.quantity == name; });
  if (of_cycle == figures.end()) return;
  of_cycle->confirmed = of_cycle->after * *at_instant.confirmed / at_instant.after;
  of_cycle->error = at_instant.error;
}

Analysis analysis_of(const Case& given, const MPI_Comm communicator, mesh::Mesher* const mesher,
                     const Progress& progress = {}) {
  AnalysisOptions options;
  options.progress = progress;
  options.mesher = mesher;
  return analyse(given, communicator, options);
}

}  // namespace

double slot_bottom_stress(const Case& given, const MPI_Comm communicator,
                          mesh::Mesher* const mesher) {
  constexpr double accuracy = 0.02;
  Case plane = given;
  plane.dimension = 2;
  plane.mechanism->space.reset();
  plane.mechanism->is_local = false;
  plane.settings.accuracy = std::max(accuracy, given.settings.accuracy);
  plane.settings.structural_accuracy = given.settings.structural_accuracy.value_or(accuracy);
  const auto stress = tensile_stress(analysis_of(plane, communicator, mesher));
  if (!stress) throw base::InputError("the wheel has no tensile stress away from the contact");
  return stress->value;
}

bool confirm(Optimum& optimum, const MPI_Comm communicator, mesh::Mesher* const mesher,
             const Progress& progress) {
  const Analysis analysis = analysis_of(optimum.best, communicator, mesher, progress);
  auto& figures = optimum.report.figures;
  figures.front().confirmed = analysis.contacts.front().peak_pressure;
  figures.front().error = analysis.error;
  confirm_cycle(figures);
  const auto stress = tensile_stress(analysis);
  if (!stress) return analysis.is_converged;
  const std::string name = model::names::slot_bottom;
  auto bottom =
      std::find_if(figures.begin(), figures.end(),
                   [&](const post::OptimumFigure& figure) { return figure.quantity == name; });
  if (bottom == figures.end())
    bottom = figures.insert(figures.end(), {name,
                                            base::Dimension::stress,
                                            std::nullopt,
                                            stress->value,
                                            std::nullopt,
                                            false,
                                            std::nullopt,
                                            std::nullopt,
                                            {}});
  bottom->confirmed = stress->value;
  bottom->error = stress->error;
  return analysis.is_converged;
}

}  // namespace geneva
