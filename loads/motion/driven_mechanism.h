#pragma once

#include <optional>
#include <vector>

#include "loads/motion/drive.h"
#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Driver, wheel and pin at an instant; derivatives with respect to time.
struct MotionState {
  double time;                     ///< [s]
  std::optional<std::size_t> pin;  ///< that is in a slot; none: the wheel rests
  Jet driver_angle;                ///< [rad]
  Jet wheel_angle;                 ///< [rad] since the first pin passed the line of centres
  double slot_angle;               ///< [rad] of the engaged slot from the line of centres
  Jet pin_distance;                ///< [m] of the engaged pin, or of the first one in a dwell
  Jet slot_position;               ///< [m] along the slot
  Jet pin_turn;                    ///< [rad], see SlotMotion
  double friction_lever;           ///< see SlotMotion
};

/// An engagement with its times.
struct TimedEngagement {
  Engagement engagement;
  double begin;  ///< [s]
  double end;    ///< [s]
};

/// A mechanism with its pins and the motion of its driver.
class DrivenMechanism {
 public:
  /// @param engagements of the pins, as engagements() gives them
  DrivenMechanism(Mechanism mechanism, const std::vector<Engagement>& engagements, Drive drive);

  [[nodiscard]] const Mechanism& mechanism() const { return mechanism_; }
  [[nodiscard]] const Drive& drive() const { return drive_; }
  /// Those that the drive covers as a whole, in order.
  [[nodiscard]] const std::vector<TimedEngagement>& engagements() const { return engagements_; }
  /// Times of rest after each engagement [s]; the last one ends with the first engagement of the
  /// next period and is left out if the drive does not cover a whole period.
  [[nodiscard]] std::vector<double> dwells() const;
  /// Times at which acceleration may jump within an engagement [s].
  [[nodiscard]] std::vector<double> joints(const TimedEngagement& engagement) const;
  /// Accelerations without bound: those of the drive, and the wheel's where the pin enters or
  /// leaves its slot at an angle to it.
  [[nodiscard]] std::vector<Unbounded> unbounded() const;

  [[nodiscard]] MotionState at_time(double time) const;
  /// @throws base::InputError unless a pin is in its slot at that driver angle, with the
  /// ranges in which one is
  [[nodiscard]] MotionState at_engaged_angle(double driver_angle) const;

 private:
  [[nodiscard]] MotionState engaged(std::size_t index, double time) const;

  Mechanism mechanism_;
  Drive drive_;
  std::vector<TimedEngagement> engagements_;
  bool is_whole_period_;
};

}  // namespace geneva::loads
