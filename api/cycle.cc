#include "api/cycle.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "api/cycle_instant.h"
#include "api/mechanism_picture.h"
#include "api/mesher_on_rank_zero.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "loads/pi.h"
#include "model/mechanism_state.h"
#include "model/naming.h"

namespace geneva {

namespace {

using post::CyclePoint;

/// Where the pin enters or leaves its slot it touches the corner of the rim, whose pressure has no
/// bound: the instant moves inwards to where the pin touches the wall.
/// @param neighbour time of the next instant inwards
void move_off_rim(loads::CycleInstant& instant, const Case& given,
                  const model::MechanismDynamics& dynamics, const double neighbour) {
  constexpr int halvings = 20;
  constexpr double share_beyond = 0.1;  // of the way on to the neighbour
  const auto load_at = [&](const double time) {
    return loads::pin_load(dynamics.driven.at_time(time), dynamics.train);
  };
  double outside = instant.load.time;
  double inside = neighbour;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (outside + inside);
    (api::touches_wall(given, load_at(middle)) ? inside : outside) = middle;
  }
  instant.load = load_at(inside + share_beyond * (neighbour - inside));
}

/// Moves the first and last instants of every engagement off the rim, and leaves out what else
/// touches only that.
/// @return notes on them
std::vector<std::string> keep_off_rim(std::vector<loads::CycleInstant>& instants, const Case& given,
                                      const model::MechanismDynamics& dynamics) {
  std::vector<std::string> notes;
  std::vector<loads::CycleInstant> kept;
  std::optional<loads::CycleInstant> outside;  // that waits for its neighbour inwards
  const auto tell = [&](const loads::CycleInstant& instant, const std::string& what) {
    notes.push_back(fmt::format(
        "at {:.6g} deg ({}) the pin touches the corner of the slot's rim, where no pressure is "
        "bounded: {}",
        instant.load.driver_angle / loads::degree, loads::name_of(instant.role), what));
  };
  const auto move = [&](loads::CycleInstant instant, const loads::CycleInstant& neighbour) {
    const loads::CycleInstant before = instant;
    if (neighbour.engagement != instant.engagement || neighbour.load.wall != instant.load.wall) {
      tell(before, "left out");
      return;
    }
    move_off_rim(instant, given, dynamics, neighbour.load.time);
    tell(before, fmt::format("solved at {:.6g} deg, on the wall",
                             instant.load.driver_angle / loads::degree));
    kept.push_back(instant);
  };
  for (const loads::CycleInstant& instant : instants) {
    const bool touches = api::touches_wall(given, instant.load);
    if (touches) {
      if (outside) move(*outside, instant);
      outside.reset();
      kept.push_back(instant);
    } else if (instant.role == loads::InstantRole::exit && !kept.empty()) {
      move(instant, loads::CycleInstant(kept.back()));
    } else if (instant.role == loads::InstantRole::entry) {
      outside = instant;
    } else {
      tell(instant, "left out");
    }
  }
  instants = std::move(kept);
  return notes;
}

/// Peak pressure over Hertz's along the instants of one wall.
class PressureRatio {
 public:
  explicit PressureRatio(const std::vector<CyclePoint>& points) : points_(points) {}

  /// Interpolated between the instants before and after, of the same engagement and wall.
  [[nodiscard]] double operator()(const loads::PinLoad& load) const {
    const CyclePoint* before = nullptr;
    const CyclePoint* after = nullptr;
    for (const CyclePoint& point : points_) {
      if (!point.contact || point.instant.load.wall != load.wall) continue;
      if (point.instant.load.time <= load.time)
        before = &point;
      else if (after == nullptr)
        after = &point;
    }
    if (before == nullptr && after == nullptr) return std::numeric_limits<double>::quiet_NaN();
    if (before == nullptr) return ratio(*after);
    if (after == nullptr) return ratio(*before);
    const double from = before->instant.load.time;
    const double share = (load.time - from) / (after->instant.load.time - from);
    return (1. - share) * ratio(*before) + share * ratio(*after);
  }

 private:
  static double ratio(const CyclePoint& point) {
    return point.contact->peak_pressure / point.hertz_pressure;
  }

  const std::vector<CyclePoint>& points_;
};

/// Heat per length and time over the speed at which its place moves.
double per_area(const double heat, const double speed) {
  if (heat == 0.) return 0.;
  return speed == 0. ? std::numeric_limits<double>::quiet_NaN() : heat / std::abs(speed);
}

/// Force exactly, pressure by its ratio to Hertz's, at fine steps of the engagements solved.
std::vector<post::CycleCurvePoint> curve_of(const std::vector<CyclePoint>& points,
                                            const loads::DrivenMechanism& driven,
                                            const loads::WheelTrain& train,
                                            const loads::PinContact& contact) {
  constexpr int steps = 200;
  const PressureRatio ratio(points);
  std::vector<post::CycleCurvePoint> curve;
  for (std::size_t i = 0; i < driven.engagements().size(); ++i) {
    if (std::none_of(points.begin(), points.end(),
                     [&](const CyclePoint& point) { return point.instant.engagement == i; }))
      continue;
    const loads::TimedEngagement& engagement = driven.engagements()[i];
    for (int step = 0; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const double time =
          std::min(engagement.begin + (engagement.end - engagement.begin) * share, engagement.end);
      const loads::MotionState motion = driven.at_time(time);
      const loads::PinLoad load = loads::pin_load(motion, train);
      const double hertz = loads::hertz_pressure(contact, load.force);
      // of a roller the heat is in its bore
      const double heat = train.slot_friction * std::abs(load.force) / contact.thickness *
                          std::abs(load.slip_speed);
      const double pin_speed = 0.5 * contact.pin_diameter * load.pin_turn_speed;
      curve.push_back({load.driver_angle, load.force, hertz, hertz * ratio(load), load.slip_speed,
                       load.pin_distance, motion.pin_turn.value, per_area(heat, load.travel_speed),
                       per_area(heat, pin_speed)});
    }
  }
  return curve;
}

/// Of the first engagement, by the trapezoidal rule's extrapolation (Simpson) at fine steps.
post::CycleWork work_of(const loads::DrivenMechanism& driven, const loads::WheelTrain& train) {
  constexpr int steps = 20000;
  const loads::TimedEngagement& engagement = driven.engagements().front();
  const double step = (engagement.end - engagement.begin) / steps;
  post::CycleWork work{};
  double taken = 0.;
  for (int i = 0; i <= steps; ++i) {
    const double weight = (i == 0 || i == steps ? 1. : i % 2 == 1 ? 4. : 2.) * step / 3.;
    const loads::PinLoad load = loads::pin_load(
        driven.at_time(std::min(engagement.begin + i * step, engagement.end)), train);
    const double power = load.moment * load.wheel_speed;
    work.pin += weight * power;
    work.driving += weight * std::max(0., power);
    work.friction += weight * loads::friction_along_wall(train) * std::abs(load.force) *
                     (train.roller ? load.bore_speed : std::abs(load.slip_speed));
    taken += weight * (train.load.friction_moment * std::abs(load.wheel_speed) +
                       train.external_torque * load.wheel_speed);
  }
  const auto speed_at = [&](const double time) { return driven.at_time(time).wheel_angle.first; };
  const double inertia = train.wheel_inertia + train.load.load_inertia;
  work.energy_change =
      taken + 0.5 * inertia *
                  (std::pow(speed_at(engagement.end), 2) - std::pow(speed_at(engagement.begin), 2));
  return work;
}

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
  std::vector<NumberedFields> solved;
  for (std::size_t i = rank; i < points.size(); i += ranks) {
    post::NodalFields fields = api::solve_instant(points[i], given, MPI_COMM_SELF, own.get());
    const loads::PinLoad& load = points[i].instant.load;
    if (points[i].contact)
      solved.push_back({i,
                        {load.driver_angle, load.pin_distance,
                         driven.at_time(load.time).pin_turn.value, std::move(fields)}});
    if (tell) tell(points[i], i + 1, points.size());
  }
  for (std::size_t i = 0; i < points.size() && ranks > 1; ++i)
    post::take_over(points[i],
                    dealii::Utilities::MPI::broadcast(communicator, post::solved_text(points[i]),
                                                      static_cast<unsigned int>(i % ranks)));
  std::vector<NumberedFields> all;
  for (std::vector<NumberedFields>& of_rank : dealii::Utilities::MPI::gather(communicator, solved))
    std::move(of_rank.begin(), of_rank.end(), std::back_inserter(all));
  std::sort(all.begin(), all.end(), [](const NumberedFields& one, const NumberedFields& other) {
    return one.point < other.point;
  });
  std::vector<post::CycleFields> fields;
  for (NumberedFields& numbered : all) fields.push_back(std::move(numbered.fields));
  return fields;
}

std::vector<std::string> notices_of(const post::CycleReport& report, const Case& given) {
  std::vector<std::string> notices = model::notices_of(*given.mechanism, given.units);
  if (report.left_out > 0)
    notices.push_back(fmt::format(
        "{} engagement{} of the cycle {} like the first one and not solved again", report.left_out,
        report.left_out > 1 ? "s" : "", report.left_out > 1 ? "are" : "is"));
  for (const CyclePoint& point : report.points)
    for (const std::string& trouble : {point.contact ? point.contact->shortfall : point.refusal,
                                       point.contact ? point.contact->hertz_objection : ""})
      if (!trouble.empty())
        notices.push_back(fmt::format("{}: {}", post::instant_in_words(point.instant), trouble));
  return notices;
}

loads::CycleInstants instants_of(const Case& given, const model::MechanismDynamics& dynamics,
                                 const loads::PinContact& contact) {
  const std::optional<int> wanted = given.mechanism->instants;
  if (wanted) return loads::even_instants(dynamics.driven, dynamics.train, *wanted);
  return loads::cycle_instants(dynamics.driven, dynamics.train, contact, given.settings.accuracy);
}

/// All but the wheel move with the pin.
std::vector<bool> bodies_that_turn(const std::vector<post::CycleFields>& fields) {
  unsigned int last = 0;
  for (const unsigned int body : fields.front().fields.bodies) last = std::max(last, body);
  std::vector<bool> turning(last + 1, true);
  turning.front() = false;
  return turning;
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
    const std::vector<std::string> moved = keep_off_rim(chosen.instants, given, dynamics);
    Cycle result{given, true, {}, {}};
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
    report.curve = curve_of(report.points, dynamics.driven, dynamics.train, contact);
    report.work = work_of(dynamics.driven, dynamics.train);
    report.notices = notices_of(report, given);
    report.notices.insert(report.notices.end(), moved.begin(), moved.end());
    report.seconds = timer.wall_time();
    result.is_converged = std::all_of(
        report.points.begin(), report.points.end(),
        [](const CyclePoint& point) { return point.contact && point.contact->shortfall.empty(); });
    return result;
  });
}

Written write(const Cycle& cycle, const std::filesystem::path& directory) {
  const auto& [given, is_converged, report, fields] = cycle;
  std::map<std::string, std::string> texts{
      {"cycle.json", post::cycle_summary(report).dump(2) + "\n"},
      {"cycle.csv", post::cycle_csv(report, given.units)},
      {"cycle_curve.csv", post::cycle_curve_csv(report, given.units)},
      {"mechanism.json", api::mechanism_text(*given.mechanism)}};
  if (const CyclePoint* const greatest = post::greatest_pressure(report)) {
    const auto at = std::find_if(fields.begin(), fields.end(), [&](const post::CycleFields& one) {
      return one.driver_angle == greatest->instant.load.driver_angle;
    });
    if (at != fields.end())
      texts.merge(post::cycle_series(fields, static_cast<std::size_t>(at - fields.begin()),
                                     bodies_that_turn(fields), given.units));
  }
  return api::write_results(directory, given, "cycle", texts);
}

}  // namespace geneva
