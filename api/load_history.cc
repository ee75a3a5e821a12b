#include "api/load_history.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/analysis_fields.h"
#include "api/analysis_notices.h"
#include "api/gathered_objects.h"
#include "api/mesher_on_rank_zero.h"
#include "api/output_directory.h"
#include "api/told_together.h"
#include "api/version.h"
#include "fem/contact_problem.h"
#include "model/case_header.h"
#include "model/model.h"
#include "model/naming.h"
#include "post/analysis/safety.h"
#include "post/analysis/surface_body.h"
#include "post/view/cycle_view.h"

namespace geneva {

namespace {

using post::ContactAtStep;
using post::LoadStepPoint;

template <std::size_t dim>
Vector vector_of(const std::array<double, dim>& components) {
  Vector vector{};
  std::copy(components.begin(), components.end(), vector.begin());
  return vector;
}

/// A contact's source nodes and what they carry at one step.
struct SourceNode {
  Vector place;
  unsigned int body;
  double pressure;
};

/// One load step of a mesh.
struct FoundStep {
  LoadStepPoint point;
  std::vector<post::SafetyRow> limits;
  std::vector<SourceNode> sources;
  post::NodalFields fields;  ///< of this rank
};

template <int dim>
std::vector<ContactAtStep> contacts_of(const fem::Solution<dim>& at_step,
                                       const post::Results<dim>& results,
                                       const fem::Instant<dim>& instant) {
  std::vector<ContactAtStep> contacts;
  for (std::size_t i = 0; i < at_step.contacts.size(); ++i) {
    const fem::ContactResult<dim>& contact = at_step.contacts[i];
    const fem::PairAtInstant<dim>& pair = instant.pairs[i];
    contacts.push_back({contact.source, contact.target, vector_of(contact.force),
                        vector_of(contact.friction_force), contact.peak_pressure,
                        post::half_width(contact, results.contacts[i]), std::nullopt, pair.sticking,
                        pair.slipping, pair.dissipated});
  }
  return contacts;
}

template <int dim>
std::vector<SourceNode> source_nodes(const fem::Solution<dim>& at_step) {
  std::vector<SourceNode> nodes;
  for (const fem::ContactResult<dim>& contact : at_step.contacts) {
    const unsigned int body = post::body_of(at_step, contact.source);
    for (const fem::ContactNode<dim>& node : contact.nodes)
      nodes.push_back({vector_of(node.position), body, node.pressure});
  }
  return nodes;
}

/// @param at_step its peak pressures corrected as the last step's are
template <int dim>
FoundStep found_step(const fem::Solution<dim>& at_step, const fem::Instant<dim>& instant,
                     const Case& given, const double time) {
  const post::Results<dim> results = post::analyse(at_step);
  post::RunReport report{};
  report.allowed = given.allowed;
  FoundStep found{{time,
                   contacts_of(at_step, results, instant),
                   {},
                   instant.energy.work,
                   instant.energy.stored},
                  post::safety(at_step, results, report),
                  source_nodes(at_step),
                  api::fields_of(at_step, results.nodal)};
  for (std::size_t body = 0; body < at_step.problem.bodies.size(); ++body)
    found.point.stresses.push_back(
        {at_step.problem.bodies[body].name, results.max_von_mises[body].value, 0.});
  return found;
}

/// What was found of every load step on the last mesh that has them all.
template <int dim>
class StepCollector {
 public:
  explicit StepCollector(const Case& given) : given_(given) {}

  void add(const std::size_t step, const fem::Solution<dim>& at_step) {
    if (step == 0) pending_.clear();
    pending_.push_back(at_step);
  }

  /// The mesh is solved.
  void take(const fem::Solution<dim>& on_mesh) {
    std::vector<fem::Solution<dim>> pending = std::exchange(pending_, {});
    std::vector<FoundStep> steps;
    for (std::size_t i = 0; i < pending.size(); ++i) {
      fem::Solution<dim>& at_step = pending[i];
      at_step.displacement.update_ghost_values();  // a copy has none
      at_step.edge = on_mesh.edge;
      for (fem::ContactResult<dim>& contact : at_step.contacts)
        contact.peak_pressure *= 1. + on_mesh.correction;
      steps.push_back(
          found_step(at_step, on_mesh.instants[i], given_, on_mesh.problem.steps[i].time));
      if (!steps_.empty()) compare(steps.back().point, steps_[i].point);
    }
    steps_ = std::move(steps);
  }

  std::vector<FoundStep> found() { return std::move(steps_); }

 private:
  static void compare(LoadStepPoint& now, const LoadStepPoint& before) {
    for (std::size_t i = 0; i < now.contacts.size(); ++i) {
      const double pressure = now.contacts[i].peak_pressure;
      if (const double last = before.contacts[i].peak_pressure; last > 0. && pressure > 0.)
        now.contacts[i].change = pressure / last - 1.;
    }
  }

  const Case& given_;
  std::vector<fem::Solution<dim>> pending_;
  std::vector<FoundStep> steps_;
};

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

/// Nodes of a field by body and place, which is the same to a billionth of the model wherever it
/// was computed.
class NodesByPlace {
 public:
  explicit NodesByPlace(const post::NodalFields& fields) {
    double extent = 0.;
    for (const Vector& place : fields.places)
      for (const double component : place) extent = std::max(extent, std::abs(component));
    cell_ = 1e-8 * extent;
    const std::vector<unsigned int> bodies = post::bodies_of_nodes(fields);
    for (std::size_t node = 0; node < fields.places.size(); ++node)
      nodes_[key(fields.places[node], bodies[node], {})].push_back(node);
  }

  [[nodiscard]] std::vector<std::size_t> at(const SourceNode& source) const {
    std::vector<std::size_t> found;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto there =
          nodes_.find(key(source.place, source.body,
                          {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1}));
      if (there != nodes_.end())
        found.insert(found.end(), there->second.begin(), there->second.end());
    }
    return found;
  }

 private:
  using Key = std::array<long, 4>;

  [[nodiscard]] Key key(const Vector& place, const unsigned int body,
                        const std::array<int, 3>& offset) const {
    Key result{0, 0, 0, static_cast<long>(body)};
    for (std::size_t i = 0; i < 3; ++i) result[i] = std::lround(place[i] / cell_) + offset[i];
    return result;
  }

  double cell_;
  std::map<Key, std::vector<std::size_t>> nodes_;
};

post::PressureEnvelope pressure_envelope(const std::vector<FoundStep>& steps,
                                         const post::NodalFields& fields) {
  const std::size_t n_nodes = fields.places.size();
  post::PressureEnvelope greatest{std::vector<double>(n_nodes, 0.),
                                  std::vector<double>(n_nodes, 0.)};
  const NodesByPlace nodes(fields);
  for (std::size_t step = 0; step < steps.size(); ++step)
    for (const SourceNode& source : steps[step].sources) {
      if (source.pressure <= 0.) continue;
      for (const std::size_t node : nodes.at(source)) {
        if (source.pressure <= greatest.pressure[node]) continue;
        greatest.pressure[node] = source.pressure;
        greatest.when[node] = static_cast<double>(step + 1);
      }
    }
  return greatest;
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
  StepCollector<dim> collector(given);
  fem::Progress<dim> watch;
  watch.step = told_together(communicator, progress.step);
  watch.level = told_together(communicator, progress.mesh);
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
    history.contact_pressure = pressure_envelope(found.steps, history.fields.front().fields);
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

/// What the report plays.
std::string view_text(const LoadHistory& history) {
  std::vector<post::InstantField> fields;
  for (const post::CycleFields& step : history.fields)
    fields.push_back({step.fields.places, step.fields.von_mises, step.fields.cells});
  return post::cycle_view(fields, history.given.units).dump() + "\n";
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
    if (given.dimension == 2) texts["load_steps_view.json"] = view_text(history);
  }
  return api::write_results(directory, given, "load_steps", texts);
}

}  // namespace geneva
