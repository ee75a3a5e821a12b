#pragma once

#include <vector>

#include "loads/motion/mechanism.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

/// A place in the frame of a mechanism [m]: the wheel turns about the z axis, x leads along the
/// line of centres to where the pin stands midway through its engagement.
struct Place {
  double x;
  double y;
  double z;
};

/// Places joined by straight lines.
using Polyline = std::vector<Place>;

/// Where the pin is, also while the wheel rests: in the plane z = 0, or on the sphere.
Place pin_place(const SlotMotion& motion);

/// The pin's way over a period, closed.
/// @param steps 1 or more
Polyline pin_path(const Mechanism& mechanism, int steps);

/// The loops of a drawn body, its arcs as chords that are off by less than a ten-thousandth of
/// their radius.
std::vector<Polyline> polylines(const Outline& outline);

/// A wheel for a mechanism whose wheel is not given in detail: rim and slots, at wheel angle 0.
/// @param slot_width [m]
Polyline schematic_wheel(const Mechanism& mechanism, double slot_width);

}  // namespace geneva::loads
