#include "loads/motion/cycle_instants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/errors.h"
#include "loads/motion/cubic_spline.h"

namespace geneva::loads {

namespace {

/// Of an engagement's time, by which an instant stands beside a jump.
constexpr double beside = 1e-9;
/// Of the greatest force: less presses on nothing.
constexpr double no_force = 1e-9;

/// A time and why it is chosen.
struct ChosenTime {
  double time;
  InstantRole role;
};

/// Part of an engagement in which one wall carries, and the force has no jump.
struct SmoothPart {
  ChosenTime begin;
  ChosenTime end;
};

/// Force and load of one mechanism over time.
class Loading {
 public:
  Loading(const DrivenMechanism& driven, const WheelTrain& train) : driven_(driven), train_(train) {
    check(train, driven);
    for (const TimedEngagement& engagement : driven.engagements())
      for (int i = 0; i <= samples; ++i)
        greatest_ = std::max(greatest_, std::abs(force(at(engagement, i))));
    if (greatest_ == 0.)
      throw base::InputError(
          "the pin never presses on a wall: there is no load; give the wheel an inertia, a "
          "friction moment or an external torque");
  }

  static constexpr int samples = 256;

  [[nodiscard]] PinLoad load(const double time) const {
    return pin_load(driven_.at_time(time), train_);
  }
  [[nodiscard]] double force(const double time) const { return load(time).force; }
  [[nodiscard]] double greatest() const { return greatest_; }
  [[nodiscard]] bool presses(const double force) const {
    return std::abs(force) > no_force * greatest_;
  }
  /// A sample's time.
  [[nodiscard]] static double at(const TimedEngagement& engagement, const int i) {
    if (i == samples) return engagement.end;
    return engagement.begin + (engagement.end - engagement.begin) * i / samples;
  }

 private:
  const DrivenMechanism& driven_;
  const WheelTrain& train_;
  double greatest_ = 0.;
};

/// Where a force changes its sign between two times, by bisection.
double zero_between(const Loading& loading, double from, double to) {
  const bool is_positive = loading.force(from) > 0.;
  for (int i = 0; i < 100 && to - from > 1e-15 * std::abs(to); ++i) {
    const double middle = 0.5 * (from + to);
    ((loading.force(middle) > 0.) == is_positive ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

/// Times at which the force of an engagement may jump, in order, without its ends.
std::vector<double> jumps(const DrivenMechanism& driven, const WheelTrain& train,
                          const TimedEngagement& engagement) {
  std::vector<double> times = driven.joints(engagement);
  if (friction_along_wall(train) > 0.)
    for (const double angle : slip_breaks(driven, train))
      times.push_back(driven.drive().time_at(engagement.engagement.middle + angle));
  const double slack = 10. * beside * (engagement.end - engagement.begin);
  times.erase(std::remove_if(times.begin(), times.end(),
                             [&](const double time) {
                               return time < engagement.begin + slack ||
                                      time > engagement.end - slack;
                             }),
              times.end());
  std::sort(times.begin(), times.end());
  return times;
}

/// The engagement without its jumps and changes of wall.
/// @param zeros out: times at which the wall changes
std::vector<SmoothPart> smooth_parts(const Loading& loading, const TimedEngagement& engagement,
                                     const std::vector<double>& jumps, std::vector<double>& zeros) {
  const double inside = beside * (engagement.end - engagement.begin);
  std::vector<SmoothPart> result;
  const auto add_smooth = [&](const ChosenTime begin, const ChosenTime end) {
    ChosenTime start = begin;
    double last = begin.time;  // at which something is pressed
    for (int i = 0; i <= Loading::samples; ++i) {
      const double share = static_cast<double>(i) / Loading::samples;
      const double time = std::min(begin.time + (end.time - begin.time) * share, end.time);
      if (!loading.presses(loading.force(time))) continue;
      if (loading.force(last) * loading.force(time) < 0.) {
        const double zero = zero_between(loading, last, time);
        zeros.push_back(zero);
        result.push_back({start, {zero, InstantRole::between}});
        start = {zero, InstantRole::between};
      }
      last = time;
    }
    result.push_back({start, end});
  };
  ChosenTime begin{engagement.begin, InstantRole::entry};
  for (const double jump : jumps) {
    add_smooth(begin, {jump - inside, InstantRole::jump});
    begin = {jump + inside, InstantRole::jump};
  }
  add_smooth(begin, {engagement.end, InstantRole::exit});
  return result;
}

/// Adds the middles of intervals in which a spline through the times is off.
/// @return whether there were any
bool add_middles(const Loading& loading, const double tolerance, std::vector<ChosenTime>& times) {
  std::vector<double> places;
  std::vector<double> forces;
  for (const ChosenTime& chosen : times) {
    places.push_back(chosen.time);
    forces.push_back(loading.force(chosen.time));
  }
  const CubicSpline spline(places, forces);
  std::vector<ChosenTime> finer;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    finer.push_back(times[i]);
    const auto is_off = [&](const double share) {
      const double time = places[i] + share * (places[i + 1] - places[i]);
      return std::abs(spline(time).value - loading.force(time)) > tolerance * loading.greatest();
    };
    if (is_off(0.25) || is_off(0.5) || is_off(0.75))
      finer.push_back({0.5 * (places[i] + places[i + 1]), InstantRole::between});
  }
  finer.push_back(times.back());
  const bool is_finer = finer.size() > times.size();
  times = std::move(finer);
  return is_finer;
}

/// Times of a part that give its force.
/// @param special others that are wanted, by time
std::vector<ChosenTime> times_of(const Loading& loading, const SmoothPart& part,
                                 const std::vector<ChosenTime>& special, const double tolerance) {
  constexpr int most_passes = 8;
  constexpr int first_intervals = 4;
  constexpr double same_instant = 1e-6;
  std::vector<ChosenTime> times{part.begin};
  const double length = part.end.time - part.begin.time;
  for (int i = 1; i < first_intervals; ++i)
    times.push_back({part.begin.time + length * i / first_intervals, InstantRole::between});
  times.push_back(part.end);
  int passes = 0;
  while (passes < most_passes && add_middles(loading, tolerance, times)) ++passes;
  // No spline goes through these: one close to another instant would make it swing.
  for (const ChosenTime& chosen : special) {
    if (chosen.time <= part.begin.time || chosen.time >= part.end.time) continue;
    const auto next = std::find_if(times.begin(), times.end(),
                                   [&](const ChosenTime& one) { return one.time > chosen.time; });
    const auto near =
        chosen.time - std::prev(next)->time < next->time - chosen.time ? std::prev(next) : next;
    if (std::abs(near->time - chosen.time) > same_instant * length)
      times.insert(next, chosen);
    else if (near->role == InstantRole::between)
      near->role = chosen.role;
  }
  return times;
}

/// The greatest forces and the greatest pressure times slip of the cycle.
std::vector<ChosenTime> special_times(const DrivenMechanism& driven, const WheelTrain& train,
                                      const PinContact& contact) {
  const Characteristics cycle = characteristics(driven, train, contact);
  std::vector<ChosenTime> times;
  for (const auto& [peak, role] :
       {std::pair(cycle.force, InstantRole::greatest_force),
        std::pair(cycle.braking_force, InstantRole::greatest_braking_force),
        std::pair(cycle.pressure_times_slip, InstantRole::greatest_pressure_times_slip)})
    if (peak.value > 0.) times.push_back({peak.time, role});
  std::sort(times.begin(), times.end(),
            [](const ChosenTime& one, const ChosenTime& other) { return one.time < other.time; });
  return times;
}

/// Whether an engagement's force is that of the first one.
bool repeats_first(const DrivenMechanism& driven, const Loading& loading, const std::size_t index) {
  const std::vector<TimedEngagement>& all = driven.engagements();
  for (int i = 0; i <= Loading::samples; i += 8) {
    const double first = loading.force(Loading::at(all.front(), i));
    const double here = loading.force(Loading::at(all[index], i));
    if (std::abs(here - first) > 1e-6 * loading.greatest()) return false;
  }
  return true;
}

/// Calls task(index, engagement) for the engagements that are not like the first one.
template <typename Task>
void for_each_engagement(const DrivenMechanism& driven, const Loading& loading,
                         CycleInstants& result, const Task& task) {
  for (std::size_t i = 0; i < driven.engagements().size(); ++i) {
    if (i > 0 && repeats_first(driven, loading, i))
      ++result.left_out;
    else
      task(i, driven.engagements()[i]);
  }
}

}  // namespace

const char* name_of(const InstantRole role) {
  switch (role) {
    case InstantRole::between:
      return "between";
    case InstantRole::entry:
      return "entry";
    case InstantRole::exit:
      return "exit";
    case InstantRole::greatest_force:
      return "greatest force";
    case InstantRole::greatest_braking_force:
      return "greatest braking force";
    case InstantRole::greatest_pressure_times_slip:
      return "greatest pressure x slip";
    case InstantRole::jump:
      return "jump";
  }
  return "";
}

CycleInstants cycle_instants(const DrivenMechanism& driven, const WheelTrain& train,
                             const PinContact& contact, const double tolerance) {
  const Loading loading(driven, train);
  const std::vector<ChosenTime> special = special_times(driven, train, contact);
  CycleInstants result;
  for_each_engagement(
      driven, loading, result, [&](const std::size_t index, const TimedEngagement& engagement) {
        const double shortest = 1e-6 * (engagement.end - engagement.begin);
        std::vector<double> zeros;
        for (const SmoothPart& part :
             smooth_parts(loading, engagement, jumps(driven, train, engagement), zeros)) {
          if (part.end.time - part.begin.time < shortest) continue;
          if (!loading.presses(loading.force(0.5 * (part.begin.time + part.end.time)))) continue;
          for (const ChosenTime& chosen : times_of(loading, part, special, tolerance))
            if (const PinLoad load = loading.load(chosen.time); loading.presses(load.force))
              result.instants.push_back({chosen.role, index, load});
        }
        for (const double zero : zeros)
          result.wall_changes.push_back(driven.drive().driver_angle(zero).value);
      });
  return result;
}

CycleInstants even_instants(const DrivenMechanism& driven, const WheelTrain& train,
                            const int count) {
  if (count < 3)
    throw base::InputError(
        fmt::format("number of instants is {}: it must be 3 or more, from entry to exit", count));
  const Loading loading(driven, train);
  CycleInstants result;
  for_each_engagement(
      driven, loading, result, [&](const std::size_t index, const TimedEngagement& engagement) {
        for (int i = 0; i < count; ++i) {
          const double share = static_cast<double>(i) / (count - 1);
          const double time = engagement.begin + share * (engagement.end - engagement.begin);
          const PinLoad load = loading.load(std::min(time, engagement.end));
          const InstantRole role = i == 0           ? InstantRole::entry
                                   : i + 1 == count ? InstantRole::exit
                                                    : InstantRole::between;
          if (loading.presses(load.force)) result.instants.push_back({role, index, load});
        }
      });
  return result;
}

}  // namespace geneva::loads
