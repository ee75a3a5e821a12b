#include "api/optimisation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "api/engagement.h"
#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/optimum_search.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "model/case_header.h"

namespace geneva {

namespace {

using api::Candidate;
using api::LimitedFigure;
using api::OptimumSearch;
using Goal = api::OptimisationGoal;

std::optional<Candidate> candidate_before(const OptimumSearch& search, const Case& given) {
  try {
    return search.candidate(given);
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

std::vector<post::OptimumFigure> report_figures(const model::OptimisationCase& wanted,
                                                const std::optional<Candidate>& before,
                                                const Candidate& after) {
  constexpr double near = 2e-3;
  std::vector<post::OptimumFigure> rows{{api::name_of(Goal::pressure),
                                         base::Dimension::stress,
                                         before ? std::optional(before->pressure) : std::nullopt,
                                         after.pressure,
                                         std::nullopt,
                                         false,
                                         std::nullopt,
                                         std::nullopt,
                                         {}}};
  const std::vector<LimitedFigure> known = api::limited_figures(wanted, after);
  const std::vector<LimitedFigure> earlier =
      before ? api::limited_figures(wanted, *before) : std::vector<LimitedFigure>();
  for (std::size_t i = 0; i < known.size(); ++i) {
    const LimitedFigure& figure = known[i];
    if (!figure.value) continue;
    rows.push_back({figure.name, figure.dimension, before ? earlier[i].value : std::nullopt,
                    *figure.value, figure.limit, figure.limit && figure.excess() > -near,
                    std::nullopt, std::nullopt, figure.place});
  }
  return rows;
}

/// What case and materials allow of the best case over the cycle.
std::vector<post::LimitRow> limits_of(const Case& best) {
  const model::MechanismCase& mechanism = *best.mechanism;
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(mechanism);
  const loads::PinContact contact = api::pin_contact(mechanism, dynamics.sizes);
  const loads::Characteristics cycle =
      loads::characteristics(dynamics.driven, dynamics.train, contact);
  return api::motion_limits(best, contact, cycle, api::limited_pressure(mechanism, cycle));
}

}  // namespace

bool wants_slot_bottom(const Case& given) {
  return given.optimisation &&
         (given.optimisation->goal == Goal::slot_bottom || given.optimisation->largest_slot_bottom);
}

Optimum optimise(const Case& given, const std::function<double(const Case&)>& slot_bottom,
                 const std::function<void(int)>& tell) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no mechanism", "geneva optimise", "mechanism");
  if (!given.optimisation)
    throw base::InputError(
        "the case leaves nothing free: give 'Free' in the subsection 'Optimisation', for example "
        "'set Free = Wheel diameter: 80 mm .. 160 mm'");
  const model::OptimisationCase& wanted = *given.optimisation;
  OptimumSearch search(given, wants_slot_bottom(given) ? slot_bottom : nullptr, tell);
  const OptimumSearch::Place best = search.best();
  Optimum optimum{given, given, {}};
  post::OptimumReport& report = optimum.report;
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.goal = api::name_of(wanted.goal);
  report.basis = search.basis() == api::PressureBasis::line_contacts ? "line contacts along the pin"
                                                                     : "Hertz, an even load";
  constexpr double on_bound = 1e-3;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const model::FreeDimension& free = wanted.free[i];
    const model::Assignment* const own = given.text.find(free.section, free.name);
    const bool has_effect = search.has_effect(best, i);
    const bool stays = !has_effect && own != nullptr;
    values.push_back(stays ? own->value : search.text_at(best, i));
    report.dimensions.push_back({free.name, own == nullptr ? "" : own->value, values.back(),
                                 !has_effect               ? ""
                                 : best[i] < on_bound      ? "lower"
                                 : best[i] > 1. - on_bound ? "upper"
                                                           : "",
                                 has_effect, has_effect ? search.refusal_beside(best, i) : ""});
  }
  optimum.best = search.case_with(values);
  report.figures =
      report_figures(wanted, candidate_before(search, given), search.candidate(optimum.best));
  report.limits = limits_of(optimum.best);
  report.trials = search.trials();
  return optimum;
}

std::string table(const Optimum& optimum) {
  return post::optimum_table(optimum.report, optimum.given.units);
}

Written write(const Optimum& optimum, const std::filesystem::path& directory) {
  return api::write_results(
      directory, optimum.given, "optimum",
      {{"optimum.json", post::optimum_summary(optimum.report).dump(2) + "\n"},
       {"optimum.csv", post::optimum_csv(optimum.report, optimum.given.units)},
       {"optimum.prm", optimum.best.completed},
       {"mechanism.json", api::mechanism_text(*optimum.best.mechanism)}});
}

}  // namespace geneva
