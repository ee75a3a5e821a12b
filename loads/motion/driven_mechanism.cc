#include "loads/motion/driven_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "loads/pi.h"

namespace geneva::loads {

namespace {

/// Driver angles formed elsewhere may differ by a few roundings from the ends of an engagement.
constexpr double angle_rounding = 1e-12;
/// A pin's path that meets its slot at a greater angle than this starts the wheel with a jump.
constexpr double maximum_defect = 1e-6;

/// Motion of the slot with respect to time from that with respect to the driver angle.
SlotMotion in_time(const SlotMotion& motion, const Jet& driver_angle) {
  return {chain(motion.wheel_angle, driver_angle), chain(motion.pin_distance, driver_angle),
          chain(motion.slot_position, driver_angle), chain(motion.pin_turn, driver_angle),
          motion.friction_lever};
}

std::string ranges(const std::vector<TimedEngagement>& engagements) {
  std::string text;
  for (const TimedEngagement& timed : engagements)
    text += fmt::format("{}from {:.6g} deg to {:.6g} deg", text.empty() ? "" : ", ",
                        timed.engagement.begin / degree, timed.engagement.end / degree);
  return text;
}

}  // namespace

DrivenMechanism::DrivenMechanism(Mechanism mechanism, const std::vector<Engagement>& engagements,
                                 Drive drive)
    : mechanism_(std::move(mechanism)), drive_(std::move(drive)) {
  const double from = drive_.driver_angle(drive_.begin).value;
  const double to = drive_.driver_angle(drive_.end).value;
  is_whole_period_ = to - from > mechanism_.period * (1. - 1e-9);
  const double slack = 1e-9 * mechanism_.period;
  for (const Engagement& engagement : engagements)
    if (engagement.begin >= from - slack && engagement.end <= to + slack)
      engagements_.push_back(
          {engagement, drive_.time_at(engagement.begin), drive_.time_at(engagement.end)});
}

std::vector<double> DrivenMechanism::dwells() const {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < engagements_.size(); ++i)
    result.push_back(std::max(0., engagements_[i + 1].begin - engagements_[i].end));
  if (is_whole_period_)
    result.push_back(engagements_.front().begin - drive_.begin + drive_.end -
                     engagements_.back().end);
  return result;
}

std::vector<double> DrivenMechanism::joints(const TimedEngagement& engagement) const {
  std::vector<double> times;
  for (const double joint : mechanism_.joints)
    times.push_back(drive_.time_at(engagement.engagement.middle + joint));
  return times;
}

std::vector<Unbounded> DrivenMechanism::unbounded() const {
  std::vector<Unbounded> places = drive_.unbounded;
  for (const TimedEngagement& timed : engagements_)
    for (const bool at_exit : {false, true}) {
      const double defect =
          tangency_defect(mechanism_, at_exit ? mechanism_.exit : mechanism_.entry);
      if (defect > maximum_defect)
        places.push_back({"wheel acceleration", at_exit ? timed.end : timed.begin,
                          at_exit ? timed.engagement.end : timed.engagement.begin,
                          fmt::format("the pin's path meets the slot at {:.4g} deg there, so that "
                                      "the wheel's speed jumps",
                                      defect / degree)});
    }
  return places;
}

MotionState DrivenMechanism::engaged(const std::size_t index, const double time) const {
  const Engagement& engagement = engagements_[index].engagement;
  const std::optional<PrescribedMotion> prescribed =
      drive_.prescribed ? drive_.prescribed(time) : std::nullopt;
  const Jet driver_angle = prescribed ? prescribed->driver_angle : drive_.driver_angle(time);
  const SlotMotion motion =
      prescribed ? prescribed->slot
                 : in_time(mechanism_.motion(driver_angle.value - engagement.middle), driver_angle);
  double steps = static_cast<double>(index);
  for (std::size_t i = 0; i < engagements_.size(); ++i)
    if (engagements_[i].engagement.pin == 0) steps -= static_cast<double>(i);
  return {time,
          engagement.pin,
          driver_angle,
          motion.wheel_angle + 2. * half_pitch(mechanism_) * steps,
          motion.wheel_angle.value,
          motion.pin_distance,
          motion.slot_position,
          motion.pin_turn,
          motion.friction_lever};
}

MotionState DrivenMechanism::at_time(const double time) const {
  std::size_t before = 0;  // engagements that have ended
  for (std::size_t i = 0; i < engagements_.size(); ++i) {
    if (time >= engagements_[i].begin && time <= engagements_[i].end) return engaged(i, time);
    if (time > engagements_[i].end) before = i + 1;
  }
  const bool is_first = before == 0;
  const std::size_t neighbour = is_first ? 0 : before - 1;
  const TimedEngagement& timed = engagements_[neighbour];
  MotionState state = engaged(neighbour, is_first ? timed.begin : timed.end);
  const double pitch = half_pitch(mechanism_);
  const Jet driver_angle = drive_.driver_angle(time);
  const SlotMotion motion = in_time(mechanism_.motion(driver_angle.value), driver_angle);
  state.wheel_angle =
      constant(state.wheel_angle.value - state.slot_angle + (is_first ? -pitch : pitch));
  return {time,
          std::nullopt,
          driver_angle,
          state.wheel_angle,
          0.,
          motion.pin_distance,
          motion.slot_position,
          motion.pin_turn,
          motion.friction_lever};
}

MotionState DrivenMechanism::at_engaged_angle(const double driver_angle) const {
  for (std::size_t i = 0; i < engagements_.size(); ++i) {
    const Engagement& engagement = engagements_[i].engagement;
    if (driver_angle >= engagement.begin - angle_rounding &&
        driver_angle <= engagement.end + angle_rounding)
      return engaged(i, drive_.time_at(driver_angle));
  }
  throw base::InputError(fmt::format(
      "driver angle is {:.6g} deg: with {} stations the pin is in the slot {}; choose an "
      "angle in this range",
      driver_angle / degree, mechanism_.stations, ranges(engagements_)));
}

}  // namespace geneva::loads
