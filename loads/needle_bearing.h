#pragma once

#include <vector>

#include "loads/allowables.h"
#include "loads/hertz.h"

namespace geneva::loads {

/// Needles between a roller's bore and its stud, in one row.
struct NeedleBearing {
  int count;        ///< Z, 3 or more
  double diameter;  ///< D_w [m]
  double length;    ///< L_w that bears [m]
};

/// Diameter [m] of the stud on which the needles run: bore less two needles.
double stud_diameter(const NeedleBearing& needles, double bore_diameter);

/// Load of the most loaded needle, 5 F/Z (R. Stribeck 1901, with the usual clearance; the share on
/// which ISO 76 rests).
double greatest_needle_load(const NeedleBearing& needles, double force);

/// Peak pressure [Pa] between the most loaded needle and the stud by Hertz, which is above that in
/// the bore: two cylinders with 1/R = 2/D_w + 2/d_s.
/// @param force of the roller on its stud, >= 0 [N]
/// @param stud material of the stud, which the needles are taken to have too
double needle_pressure(const NeedleBearing& needles, double bore_diameter, double force,
                       const Elastic& stud);

/// Pressure up to which needle and hardened raceway (HRC 58 or more) keep a dent of less than a
/// ten-thousandth of the needle's diameter [Pa] (ISO 76).
constexpr double static_needle_pressure = 4e9;

/// A pressure that the most loaded needle and its stud stand.
struct NeedleLimit {
  const char* name;
  double pressure;  ///< [Pa]
  const char* meaning;
};

/// That of ISO 76, and of a stud whose strength is known the one up to which it shakes down.
std::vector<NeedleLimit> needle_limits(const Allowables& allowed);

/// @throws base::InputError unless the needles are three or more of positive sizes, fit beside each
/// other on their pitch circle and leave a stud in the bore
void check(const NeedleBearing& needles, double bore_diameter);

}  // namespace geneva::loads
