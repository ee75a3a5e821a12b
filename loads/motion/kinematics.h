#pragma once

#include <vector>

#include "loads/hertz.h"
#include "loads/motion/driven_mechanism.h"
#include "loads/motion/pin_load.h"

namespace geneva::loads {

/// Pin and slot wall where they touch.
struct PinContact {
  double contact_modulus;  ///< E* [Pa]
  double thickness;        ///< t of the wheel [m]
  double pin_diameter;     ///< d [m]
};

/// Hertz's peak pressure [Pa] of a pin on a flat wall under a force of either sign; 0 without one.
double hertz_pressure(const PinContact& contact, double force);

/// Mean pressure [Pa] on a roller's stud, F/(d_b t), under a force of either sign; 0 of a fixed
/// pin.
double bore_pressure(const PinContact& contact, const WheelTrain& train, double force);

/// Mechanism at one instant of its cycle.
struct KinematicsRow {
  MotionState motion;
  PinLoad load;     ///< in a dwell without moment and force
  double pressure;  ///< [Pa]
};

/// The mechanism at equal steps of time over the cycle, and at the ends of the engagements.
/// @param steps number of steps, 1 or more
/// @throws base::InputError otherwise
std::vector<KinematicsRow> kinematics_rows(const DrivenMechanism& driven, const WheelTrain& train,
                                           const PinContact& contact, int steps);

/// A maximum value and where it occurs.
struct PlacedPeak {
  double value;
  double driver_angle;  ///< [rad]
  double time;          ///< [s]
};

/// What characterises a mechanism and its load. Ratios are those to powers of the drive's reference
/// speed: they are dphi/dtheta and its derivatives where the driver turns at constant speed.
struct Characteristics {
  PlacedPeak speed_ratio;         ///< maximum, of the wheel
  PlacedPeak acceleration_ratio;  ///< maximum forwards, at Johnson's point
  PlacedPeak jerk_ratio;          ///< maximum size
  double entry_acceleration_ratio;
  double
      jerk_ratio_at_centre;  ///< midway through the first engagement; negative for an external one
  double engagement_angle;   ///< of the driver, from entry to exit [rad]
  double motion_time;        ///< of the first engagement [s]
  std::vector<double> dwell_times;  ///< [s], see DrivenMechanism::dwells()
  double motion_fraction;           ///< motion over the whole time
  double time_ratio;                ///< k_t: motion over dwell; infinite without dwell
  PlacedPeak force;                 ///< maximum on the driving wall [N]; 0 if there is none
  PlacedPeak braking_force;         ///< maximum on the braking wall [N]; 0 if there is none
  // Maximum values over those at Johnson's point; NaN where nothing presses on the driving wall.
  double force_ratio;
  PlacedPeak pressure;  ///< Hertz, on either wall [Pa]
  double pressure_ratio;
  PlacedPeak pressure_times_slip;  ///< on the wall; 0 of a roller [Pa m/s]
  double pressure_times_slip_ratio;
  PlacedPeak slip_speed;  ///< maximum size on the wall that carries; 0 of a roller [m/s]
  PlacedPeak bore_pressure_times_speed;  ///< mean pressure in a roller's bore times the speed at
                                         ///< which it slides there; 0 of a fixed pin [Pa m/s]
  std::vector<SlipReversal> slip_reversals;  ///< of a pin fixed to its carrier; a roller turns on
                                             ///< its stud the other way from there on
  double entry_tangency;  ///< angle between the pin's path and the slot at entry [rad]; 0: no jump
  double exit_tangency;   ///< at exit [rad]
};

/// @throws base::InputError where check() of the train does
Characteristics characteristics(const DrivenMechanism& driven, const WheelTrain& train,
                                const PinContact& contact);

}  // namespace geneva::loads
