#include "api/load_history.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/analysis_notices.h"
#include "api/found_steps.h"
#include "api/gathered_objects.h"
#include "api/mesher_on_rank_zero.h"
#include "api/output_directory.h"
#include "api/source_pressure.h"
#include "api/told_together.h"
#include "api/version.h"
#include "api/view_text.h"
#include "fem/contact_problem.h"
#include "model/case_header.h"
#include "model/model.h"
#include "model/naming.h"
#include "post/analysis/safety.h"
#include "post/output/cycle_series.h"

namespace geneva {

namespace {

using api::FoundStep;
using post::LoadStepPoint;

/// The parts of all ranks as one.
post::NodalFields joined(const std::vector<post::NodalFields>& parts) {
  post::NodalFields all;
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const post::NodalFields& part : parts) {
    const std::size_t first = all.places.size();
    append(all.places, part.places);
    append(all.displacements, part.displacements);
    append(all.stress, part.stress);
    append(all.von_mises, part.von_mises);
    append(all.bodies, part.bodies);
    for (std::vector<std::size_t> cell : part.cells) {
      for (std::size_t& node : cell) node += first;
      all.cells.push_back(std::move(cell));
    }
  }
  return all;
}

/// Maximum first principal stress of the bodies, over all ranks.
void find_tension(LoadStepPoint& point, const post::NodalFields& fields,
                  const MPI_Comm communicator) {
  std::vector<double> greatest(point.stresses.size(), std::numeric_limits<double>::lowest());
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
    for (const std::size_t node : fields.cells[cell]) {
      double& of_body = greatest[fields.bodies[cell]];
      of_body = std::max(of_body, post::first_principal(fields.stress[node]));
    }
  dealii::Utilities::MPI::max(greatest, communicator, greatest);
  for (std::size_t body = 0; body < greatest.size(); ++body)
    point.stresses[body].first_principal = greatest[body];
}

/// The last mesh's steps.
template <int dim>
struct SolvedSteps {
  fem::Solution<dim> solution;
  std::vector<FoundStep> steps;
};

/// Every limit at the step where it is nearest.
/// @param of_steps rows by step, which need not be the same ones
std::vector<post::LimitRow> nearest_limits(
    const std::vector<std::vector<post::SafetyRow>>& of_steps) {
  std::vector<post::LimitRow> limits;
  std::vector<std::string> names;  // of the limits, without their steps
  for (std::size_t step = 0; step < of_steps.size(); ++step)
    for (const post::SafetyRow& row : of_steps[step]) {
      if (!row.computed) continue;
      const post::LimitRow here{fmt::format("{} (load step {})", row.quantity, step + 1),
                                row.dimension,
                                *row.computed,
                                row.allowed,
                                std::nullopt,
                                row.meaning};
      const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), row.quantity) -
                                               names.begin());
      if (at == names.size()) {
        names.push_back(row.quantity);
        limits.push_back(here);
      } else if (here.factor() < limits[at].factor()) {
        limits[at] = here;
      }
    }
  return limits;
}

/// Those of the steps; stresses away from the contact are known of the last one alone, and where a
/// pressure is not bounded nothing else is.
template <int dim>
std::vector<post::LimitRow> limits_of(const Case& given, const SolvedSteps<dim>& found) {
  std::vector<std::vector<post::SafetyRow>> of_steps;
  for (const FoundStep& step : found.steps)
    of_steps.push_back(post::is_bounded(found.solution) ? step.limits
                                                        : std::vector<post::SafetyRow>());
  post::RunReport report{};
  report.allowed = given.allowed;
  of_steps.back() = post::safety(found.solution, post::analyse(found.solution), report);
  return nearest_limits(of_steps);
}

template <int dim>
SolvedSteps<dim> solved_steps(const Case& given, const MPI_Comm communicator,
                              const model::Model<dim>& model, const Progress& progress) {
  api::StepCollector<dim> collector(given);
  fem::Progress<dim> watch;
  watch.step = told_together(communicator, progress.step);
  watch.level = told_together(communicator, progress.mesh);
  watch.work = told_together(communicator, progress.work);
  watch.load_step = [&](const std::size_t step, const fem::Solution<dim>& at_step) {
    collector.add(step, at_step);
  };
  watch.solution = [&](const fem::Solution<dim>& on_mesh) { collector.take(on_mesh); };
  fem::Solution<dim> solution = model::naming(given, [&] {
    return fem::solve_contact(communicator, model.mesh, model.problem, given.settings, watch);
  });
  std::vector<FoundStep> steps = collector.found();
  if (steps.size() != model.problem.steps.size())
    throw LimitReached(
        "memory ran out before the load steps of a mesh were kept; give less to 'Maximum "
        "unknowns', "
        "or fewer 'Load steps'");
  return {std::move(solution), std::move(steps)};
}

template <int dim>
post::LoadHistoryReport report_of(const Case& given, const model::Model<dim>& model,
                                  const SolvedSteps<dim>& found) {
  post::LoadHistoryReport report;
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.accuracy = given.settings.accuracy;
  if (found.solution.error_estimate < 1.) report.error = found.solution.error_estimate;
  report.notices = model.notices;
  report.notices.insert(report.notices.end(), given.notices.begin(), given.notices.end());
  const std::string shortfall = api::shortfall(found.solution, report.accuracy);
  if (!shortfall.empty()) report.notices.push_back(shortfall);
  report.is_bounded = post::is_bounded(found.solution);
  if (!report.is_bounded)
    report.notices.emplace_back(
        "the pressure is not bounded: it grows with every mesh where the contact reaches a sharp "
        "edge, and no limit of it is judged");
  if (!given.allowed.yield_strengths.empty() || !given.allowed.fatigue_strengths.empty())
    report.notices.emplace_back(
        "stresses away from the contact are judged at the last load step alone");
  report.limits = limits_of(given, found);
  for (const FoundStep& step : found.steps) report.steps.push_back(step.point);
  return report;
}

template <int dim>
LoadHistory history_of(const Case& given, const MPI_Comm communicator, mesh::Mesher* const started,
                       const Progress& progress) {
  const dealii::Timer timer;
  api::MesherOnRankZero mesher(communicator, started);
  const model::Model<dim> model = model::naming(
      given, [&] { return model::make_model<dim>(communicator, given, mesher.get()); });
  if (progress.start)
    end_together(communicator, [&] {
      progress.start({api::heading(given, model), model.notices, {}});
    });
  SolvedSteps<dim> found = solved_steps(given, communicator, model, progress);
  for (FoundStep& step : found.steps) find_tension(step.point, step.fields, communicator);
  LoadHistory history{
      given, fem::is_success(found.solution.stop.outcome), report_of(given, model, found), {}, {}};
  for (FoundStep& step : found.steps) {
    const auto parts = api::gathered_objects(communicator, std::exchange(step.fields, {}));
    const double number = static_cast<double>(history.fields.size() + 1);
    if (!parts.empty()) history.fields.push_back({number, 0., 0., joined(parts)});
  }
  if (!history.fields.empty())
    history.contact_pressure = api::pressure_envelope(found.steps, history.fields.front().fields);
  history.report.ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  history.report.seconds = timer.wall_time();
  return history;
}

/// @throws InputError without load steps or contact
void check_that_it_has_steps(const Case& given) {
  if (!given.geometry)
    model::refuse_model(given, "there are no load steps", "geneva cycle", "geometry");
  std::visit(
      [&](const auto& problem) {
        model::naming(given, [&] {
          if (problem.steps.empty())
            throw InputError(
                "'geneva cycle' goes through the load steps of a geometry, and there are none: "
                "give "
                "'Load steps', a table of the shares of the loads against time, or use 'geneva "
                "run' "
                "for all loads at once");
          if (!fem::has_contact(problem))
            throw InputError(
                "'geneva cycle' goes through the load steps of a contact, and there is none: give "
                "'Contact pairs', or use 'geneva run' for the last step");
        });
      },
      given.geometry->problem);
}

}  // namespace

LoadHistory load_history(const Case& given, const MPI_Comm communicator, mesh::Mesher* const mesher,
                         const Progress& progress) {
  check_that_it_has_steps(given);
  return given.dimension == 3 ? history_of<3>(given, communicator, mesher, progress)
                              : history_of<2>(given, communicator, mesher, progress);
}

std::string table(const LoadHistory& history) {
  return post::load_history_table(history.report, history.given.units);
}

Written write(const LoadHistory& history, const std::filesystem::path& directory) {
  const auto& [given, is_converged, report, fields, contact_pressure] = history;
  std::map<std::string, std::string> texts{
      {"load_steps.json", post::load_history_summary(report).dump(2) + "\n"},
      {"load_steps.csv", post::load_history_csv(report, given.units)}};
  if (!fields.empty()) {
    const unsigned int last =
        *std::max_element(fields.front().fields.bodies.begin(), fields.front().fields.bodies.end());
    const std::vector<bool> turning(last + 1, false);
    texts.merge(post::cycle_series(
        fields, fields.front().fields, post::envelope(fields.front(), fields, turning),
        {"load_step", 1., "load_steps", "load_steps_envelope.vtu"}, contact_pressure, given.units));
    if (given.dimension == 2) texts["load_steps_view.json"] = api::view_text(fields, given.units);
  }
  return api::write_results(directory, given, "load_steps", texts);
}

}  // namespace geneva
