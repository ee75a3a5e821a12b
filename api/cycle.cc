#include "api/cycle.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "api/cycle_curve.h"
#include "api/cycle_envelope.h"
#include "api/cycle_instant.h"
#include "api/cycle_rim.h"
#include "api/gathered_objects.h"
#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/mesher_on_rank_zero.h"
#include "api/output_directory.h"
#include "api/shared_counter.h"
#include "api/told_together.h"
#include "api/version.h"
#include "api/view_text.h"
#include "loads/pi.h"
#include "model/case_header.h"
#include "model/mechanism_state.h"
#include "model/naming.h"
#include "post/output/cycle_series.h"

namespace geneva {

namespace {

using post::CyclePoint;

/// Fields of an instant with its place in the list.
struct NumberedFields {
  std::size_t point;
  post::CycleFields fields;

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    archive& point& fields;
  }
};

/// Solves the points that are a rank's and tells all ranks of them.
/// @return the fields on rank 0, in the order of the points
std::vector<post::CycleFields> solve_shared(
    std::vector<CyclePoint>& points, const Case& given, const loads::DrivenMechanism& driven,
    const MPI_Comm communicator, mesh::Mesher* const mesher,
    const std::function<void(const CyclePoint&, std::size_t, std::size_t)>& tell) {
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  const unsigned int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  api::MesherOnRankZero own(MPI_COMM_SELF, mesher);
  api::SharedCounter counter(communicator);
  std::vector<NumberedFields> solved;
  std::vector<unsigned int> solver(points.size(), 0);  // rank
  std::exception_ptr thrown;
  for (std::size_t i = counter.next(); i < points.size(); i = counter.next()) {
    solver[i] = rank;
    post::NodalFields fields = api::solve_instant(points[i], given, MPI_COMM_SELF, own.get());
    const loads::PinLoad& load = points[i].instant.load;
    // A block of wall and its pin stand where they touch, whatever the instant.
    const bool is_local = given.mechanism->is_local;
    if (points[i].contact)
      solved.push_back(
          {i,
           {load.driver_angle, is_local ? 0. : load.pin_distance,
            is_local ? 0. : driven.at_time(load.time).pin_turn.value, std::move(fields)}});
    try {
      if (tell) tell(points[i], i + 1, points.size());
    } catch (...) {
      thrown = std::current_exception();
      while (counter.next() < points.size()) continue;  // nothing is left for the other ranks
    }
  }
  end_together(communicator, [&] {
    if (thrown) std::rethrow_exception(thrown);
  });
  dealii::Utilities::MPI::max(solver, communicator, solver);
  for (std::size_t i = 0; i < points.size() && ranks > 1; ++i)
    post::take_over(points[i], fem::text_of(communicator, solver[i], post::solved_text(points[i])));
  std::vector<NumberedFields> all;
  for (std::vector<NumberedFields>& of_rank :
       api::gathered_objects(communicator, std::move(solved)))
    std::move(of_rank.begin(), of_rank.end(), std::back_inserter(all));
  std::sort(all.begin(), all.end(), [](const NumberedFields& one, const NumberedFields& other) {
    return one.point < other.point;
  });
  std::vector<post::CycleFields> fields;
  for (NumberedFields& numbered : all) fields.push_back(std::move(numbered.fields));
  return fields;
}

/// Where the torque that the shaft takes is not what the load asks for, by a share of the greatest.
std::vector<std::string> torque_notices(const post::CycleReport& report) {
  constexpr double limit = 5e-3;
  double greatest = 0.;
  for (const CyclePoint& point : report.points)
    if (point.contact) greatest = std::max(greatest, std::abs(point.contact->expected_bore_torque));
  std::vector<std::string> notices;
  for (const CyclePoint& point : report.points) {
    if (!point.contact || !point.contact->bore_torque) continue;
    const double difference =
        std::abs(*point.contact->bore_torque - point.contact->expected_bore_torque) / greatest;
    if (difference > limit)
      notices.push_back(fmt::format(
          "{}: the torque that the wheel's shaft takes is off by {:.2g} % of the greatest one",
          post::instant_in_words(point.instant), 100. * difference));
  }
  return notices;
}

std::vector<std::string> notices_of(const post::CycleReport& report, const Case& given) {
  std::vector<std::string> notices = given.notices;
  for (const std::string& notice : model::notices_of(*given.mechanism, given.units))
    notices.push_back(notice);
  if (report.left_out > 0)
    notices.push_back(fmt::format(
        "{} engagement{} of the cycle {} like the first one and not solved again", report.left_out,
        report.left_out > 1 ? "s" : "", report.left_out > 1 ? "are" : "is"));
  for (const CyclePoint& point : report.points)
    for (const std::string& trouble : {point.contact ? point.contact->shortfall : point.refusal,
                                       point.contact ? point.contact->hertz_objection : ""})
      if (!trouble.empty())
        notices.push_back(fmt::format("{}: {}", post::instant_in_words(point.instant), trouble));
  for (const std::string& notice : torque_notices(report)) notices.push_back(notice);
  return notices;
}

loads::CycleInstants instants_of(const Case& given, const model::MechanismDynamics& dynamics,
                                 const loads::PinContact& contact) {
  const std::optional<int> wanted = given.mechanism->instants;
  if (wanted) return loads::even_instants(dynamics.driven, dynamics.train, *wanted);
  return loads::cycle_instants(dynamics.driven, dynamics.train, contact, given.settings.accuracy);
}

}  // namespace

Cycle cycle(const Case& given, const MPI_Comm communicator, mesh::Mesher* const mesher,
            const std::function<void(const CyclePoint&, std::size_t, std::size_t)>& tell) {
  const dealii::Timer timer;
  return model::naming(given, [&] {
    if (!given.mechanism)
      model::refuse_model(given, "there is no Geneva mechanism", "geneva cycle", "mechanism");
    const model::MechanismDynamics dynamics = model::mechanism_dynamics(*given.mechanism);
    const loads::PinContact contact = api::pin_contact(*given.mechanism, dynamics.sizes);
    loads::CycleInstants chosen = instants_of(given, dynamics, contact);
    const std::vector<std::string> moved = api::keep_off_rim(chosen.instants, given, dynamics);
    Cycle result{given, true, {}, {}, {}};
    post::CycleReport& report = result.report;
    report.about = model::header_of(given);
    report.geneva_version = version;
    report.mechanism = dynamics.driven.mechanism().name;
    report.accuracy = given.settings.accuracy;
    report.wall_changes = chosen.wall_changes;
    report.left_out = chosen.left_out;
    report.ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    for (const loads::CycleInstant& instant : chosen.instants)
      report.points.push_back(
          {instant, loads::hertz_pressure(contact, instant.load.force), std::nullopt, ""});
    result.fields = solve_shared(report.points, given, dynamics.driven, communicator, mesher, tell);
    report.swings = api::swings_of(communicator, given, report, result.fields);
    report.curve = api::curve_of(report.points, dynamics.driven, dynamics.train, contact);
    result.envelope = api::cycle_envelope(communicator, given, report, result.fields);
    report.work = api::work_of(dynamics.driven, dynamics.train);
    report.limits = api::cycle_limits(given, contact, report);
    report.notices = notices_of(report, given);
    report.notices.insert(report.notices.end(), moved.begin(), moved.end());
    report.seconds = timer.wall_time();
    result.is_converged = std::all_of(
        report.points.begin(), report.points.end(),
        [](const CyclePoint& point) { return point.contact && point.contact->shortfall.empty(); });
    return result;
  });
}

std::string table(const Cycle& cycle) { return post::cycle_table(cycle.report, cycle.given.units); }

Written write(const Cycle& cycle, const std::filesystem::path& directory) {
  const auto& [given, is_converged, report, fields, envelope] = cycle;
  std::map<std::string, std::string> texts{
      {"cycle.json", post::cycle_summary(report).dump(2) + "\n"},
      {"cycle.csv", post::cycle_csv(report, given.units)},
      {"cycle_curve.csv", post::cycle_curve_csv(report, given.units)},
      {"mechanism.json", api::mechanism_text(*given.mechanism)}};
  if (envelope) {
    if (given.dimension == 2) texts["cycle_view.json"] = api::view_text(fields, given.units);
    texts.merge(post::cycle_series(
        fields, envelope->nodes, envelope->greatest,
        {"driver_angle", base::output_unit(given.units, base::Dimension::angle).factor, "cycle",
         "envelope.vtu"},
        envelope->pressure, given.units));
  }
  return api::write_results(directory, given, "cycle", texts);
}

}  // namespace geneva
