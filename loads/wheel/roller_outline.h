#pragma once

#include <vector>

#include "loads/wheel/outline.h"

namespace geneva::loads {

/// The stud on which a roller turns; SI units.
struct Stud {
  double bore_diameter;  ///< d_b of the roller [m]
  double clearance;      ///< bore diameter less the stud's, 0 or more [m]
  double core_radius;    ///< of the stud's middle, which is held [m]
};

/// A solid pin as a roller on its stud: a ring, and the stud in its bore, which it touches on the
/// side of the driving wall (+y).
///
/// Surfaces: "pin", "roller bore", "roller guide" (narrow strips of both on the far side, where the
/// ring, which nothing else keeps from turning, is guided), "stud", "pin core".
/// @param pin as pin_outline() draws it
/// @throws base::InputError unless the bore is at most 95 % of the roller, the clearance 0 to a
/// tenth of the bore, and the core lies inside the stud
std::vector<Outline> roller_outlines(const Outline& pin, const Stud& stud);

}  // namespace geneva::loads
