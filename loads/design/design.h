#pragma once

#include <optional>
#include <vector>

#include "loads/design/johnson.h"
#include "loads/hertz.h"
#include "loads/motion/pin_load.h"

namespace geneva::loads {

/// What the lengths that a wheel was given become when it is drawn with another diameter.
enum class GivenLengths {
  scale,  ///< they keep their proportion to the diameter
  stay    ///< they keep their value; those not given follow the diameter
};

/// The wheel to be designed and what it has to move; SI units.
struct DesignInput {
  GenevaDimensionsInput dimensions;  ///< with one of its sizes, as complete_dimensions() wants it
  GivenLengths given_lengths;
  WheelLoad load;
  double driver_speed;  ///< constant [rad/s]
  double density;       ///< of the wheel [kg/m^3]
  Elastic pin;
  Elastic wheel;
};

/// A wheel of the design at the angle of maximum wheel acceleration, -beta.
struct DesignedWheel {
  double diameter;  ///< D [m]
  double pin_diameter;
  double thickness;
  double locking_radius;
  double inertia;        ///< J_G [kg m^2]
  double force;          ///< F_max [N] (Johnson 1956, Eq. 1)
  double peak_pressure;  ///< s_max [Pa] (Eq. 2 and 3)
};

/// The same wheel with another diameter.
/// @param rule what given lengths do
/// @param diameter D > 0 [m]
GenevaDimensionsInput resized(const GenevaDimensionsInput& input, GivenLengths rule,
                              double diameter);

/// The wheel's maximum acceleration a_max [rad/s^2], at -beta.
/// @throws base::InputError unless the driver's speed is positive
double design_acceleration(const DesignInput& input);

/// A wheel of Johnson's proportions, with his inertia J_G = k5 rho D^5 (Johnson 1956, Eq. 1 to 8).
/// @param diameter D > 0 [m]
/// @throws base::InputError beyond 10 stations, where Johnson gives no k5, or where
/// design_acceleration() or johnson_stress() does
DesignedWheel johnson_wheel(const DesignInput& input, double diameter);

/// The wheel as complete_dimensions() draws it, with the inertia of that drawing.
/// @param diameter D > 0 [m]
/// @throws base::InputError if no such wheel can be drawn, or where design_acceleration() or
/// johnson_stress() does
DesignedWheel drawn_wheel(const DesignInput& input, double diameter);

/// Johnson's wheel of the minimum contact stress: Eq. 9, then D from Eq. 6 and F and s from Eq. 1
/// to 3; nothing beyond 10 stations.
/// @throws base::InputError if neither inertia nor friction loads the wheel: the stress then
/// falls with the diameter and has no minimum
std::optional<DesignedWheel> johnson_optimum(const DesignInput& input);

/// The drawn wheel of the minimum contact stress.
struct DrawnOptimum {
  DesignedWheel wheel;
  double inertia_ratio;  ///< J_G/(J_L + M_f/a): 1.5 by Eq. 9 where all lengths scale
  bool at_limit;         ///< the stress falls as far as such a wheel can be drawn
};

/// Where all lengths scale, J_G = k D^5 holds for the drawn wheel too, with another k than
/// Johnson's k5, and so does Eq. 9. Where given lengths stay, neither inertia nor t d follow their
/// powers of D: the minimum is then looked for on 400 logarithmic steps from a tenth to ten times
/// that diameter, and to 1e-7 of the diameter between two of them.
/// @throws base::InputError where johnson_optimum() does, or if no such wheel can be drawn
DrawnOptimum drawn_optimum(const DesignInput& input);

/// Both wheels of one diameter; nothing where one does not exist.
struct DesignPoint {
  double diameter;
  std::optional<DesignedWheel> johnson;
  std::optional<DesignedWheel> drawn;
};

/// Stress against diameter (Eq. 8) in logarithmic steps from first to last diameter.
/// @param first, last diameters [m], 0 < first < last
/// @param steps >= 1; there is one point more
/// @throws base::InputError outside these ranges, or where design_acceleration() does
std::vector<DesignPoint> design_curve(const DesignInput& input, double first, double last,
                                      int steps);

/// A row of Johnson's Table 1 with the inertia constant of the drawn wheel.
struct DesignTableRow {
  JohnsonRow johnson;
  double drawn_k5;  ///< J_G/(rho D^5) of a wheel with k2 to k4 as drawn, without bore
};

/// Table 1 for 3 to 24 stations.
std::vector<DesignTableRow> design_table();

/// Motion and dwell of a wheel with one pin and a driver of constant speed (Lecture 4, t_m and t_s;
/// ME341, example).
struct WorkingCycle {
  double motion_time;      ///< t_m [s]
  double dwell_time;       ///< t_s [s]
  double motion_fraction;  ///< (n - 2)/(2 n) of the driver's turn
  double time_ratio;       ///< k_t = t_m/t_s = (n - 2)/(n + 2)
  int maximum_pins;        ///< floor(2 n/(n - 2)) equally spaced pins never meet the wheel together
};

/// @param stations n, 3..24
/// @param driver_speed omega > 0 [rad/s]
/// @throws base::InputError outside these ranges
WorkingCycle working_cycle(int stations, double driver_speed);

}  // namespace geneva::loads
