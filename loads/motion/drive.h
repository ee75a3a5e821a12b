#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loads/motion/mechanism.h"
#include "loads/motion/motion_law.h"

namespace geneva::loads {

/// Where an acceleration has no bound.
struct Unbounded {
  std::string quantity;  ///< "driver acceleration" or "wheel acceleration"
  double time;           ///< [s]
  double driver_angle;   ///< [rad]
  std::string cause;     ///< why, in words
};

/// Driver and wheel with respect to time.
struct PrescribedMotion {
  Jet driver_angle;
  SlotMotion slot;
};

/// How the driver moves: its angle against time, over a span of time that covers whole engagements.
struct Drive {
  double begin;            ///< [s]
  double end;              ///< [s]
  double reference_speed;  ///< omega [rad/s], by whose powers speed, acceleration and jerk ratios
                           ///< are formed
  std::function<Jet(double time)> driver_angle;        ///< [rad], derivatives with respect to time
  std::function<double(double driver_angle)> time_at;  ///< [s], the inverse
  /// Motion of the wheel with respect to time, where that is what is prescribed; empty: it follows
  /// from the driver angle.
  std::function<std::optional<PrescribedMotion>(double time)> prescribed;
  std::vector<Unbounded> unbounded;
};

/// theta = omega t over one period.
/// @throws base::InputError unless the speed is positive
Drive constant_speed(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                     double speed);

/// theta = omega t + epsilon t^2/2: omega is the speed at driver angle 0. Over one period, or over
/// the engagements alone if the driver would stand still in the period.
/// @throws base::InputError unless the speed is positive, or if the driver would stand still
/// within an engagement
Drive constant_acceleration(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                            double speed, double acceleration);

/// The cubic spline through a table. The reference speed is the mean speed over the table.
/// @param times [s], increasing
/// @param angles [rad], increasing
/// @throws base::InputError if the table has fewer than four rows, is unsorted, not finite, or
/// if the spline turns back between rows; or if it covers no engagement as a whole
Drive table(const std::vector<Engagement>& engagements, const std::vector<double>& times,
            const std::vector<double>& angles);

/// A law of motion set on the carrier (driver): in each engagement theta runs from entry to exit as
/// A(k), k from 0 to 1 in the motion time; between, the driver runs at the reference speed, which
/// is engagement angle over motion time.
/// @throws base::InputError unless the motion time is positive
Drive law_on_carrier(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                     MotionLaw law, double motion_time);

/// Which of the two plane mechanisms of a crank and parallel axes.
enum class PlaneGeneva { external, internal };

/// A law of motion set on the cross (wheel): phi runs from -pi/n to pi/n as A(k), and the carrier's
/// angle follows (Kolomiets et al., Eq. 4 - 7): theta = beta - phi, beta = asin(sin phi/sin(pi/n));
/// internal Geneva: theta = beta + phi. Between the engagements as in law_on_carrier().
///
/// The carrier's acceleration is unbounded at the ends unless A grows with the square of time
/// there.
/// @param mechanism the external or internal Geneva
/// @param centre_distance of that mechanism [m]
/// @throws base::InputError unless the motion time is positive
Drive law_on_cross(const Mechanism& mechanism, PlaneGeneva kind, double centre_distance,
                   const std::vector<Engagement>& engagements, MotionLaw law, double motion_time);

}  // namespace geneva::loads
