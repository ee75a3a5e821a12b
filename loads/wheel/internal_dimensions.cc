#include "loads/wheel/internal_dimensions.h"

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/refuse.h"

namespace geneva::loads {

namespace {

/// The pin presses on the straight wall, so its axis must not pass the bottom's centre.
void check_slot_depth(const InternalDimensions& dimensions) {
  const double farthest = dimensions.centre_distance + dimensions.crank_radius;
  const double minimum_depth =
      farthest - dimensions.wheel_diameter / 2. + dimensions.slot_width / 2.;
  if (dimensions.slot_depth < minimum_depth - dimension_rounding * dimensions.wheel_diameter)
    refuse(
        "slot depth is {0:.6g} mm: the pin goes as far as {1:.6g} mm from the wheel's axis and "
        "needs a slot of at least {2:.6g} mm; make the slot deeper",
        mm(dimensions.slot_depth), mm(farthest), mm(minimum_depth));
}

/// Slots diverge outwards, so two neighbours are nearest where they open.
void check_neighbouring_slots(const InternalDimensions& dimensions) {
  const double spacing = dimensions.wheel_diameter * std::sin(pi / dimensions.stations);
  if (dimensions.slot_width >= spacing)
    refuse(
        "slot width is {:.6g} mm: neighbouring slots run into each other, since their centre lines "
        "are {:.6g} mm apart at the inner rim of diameter {:.6g} mm and the width must be less; "
        "make the slots narrower, with a thinner pin",
        mm(dimensions.slot_width), mm(spacing), mm(dimensions.wheel_diameter));
}

void check_rim(const InternalDimensions& dimensions) {
  require_positive_length("rim radius", dimensions.rim_radius);
  const double deepest = dimensions.wheel_diameter / 2. + dimensions.slot_depth;
  if (dimensions.rim_radius <= deepest)
    refuse(
        "rim radius is {:.6g} mm: the slots reach {:.6g} mm from the wheel's axis and the rim must "
        "lie outside; make the rim radius larger or the slots shallower",
        mm(dimensions.rim_radius), mm(deepest));
}

/// The arc's centre stands at x = D/2, y = r in the slot's frame, beside the straight wall, so that
/// arc and wall are nearest there. An arc that is clear of the walls leaves a tip at the inner rim
/// and stays within c + r - slot_width/2 of the wheel's axis, inside the outer rim.
void check_locking_arc_clears_slot(const InternalDimensions& dimensions) {
  const double maximum = dimensions.crank_radius - dimensions.slot_width / 2.;
  if (dimensions.locking_radius >= maximum)
    refuse(
        "locking radius is {:.6g} mm: the locking arc cuts into the slot of width {:.6g} mm unless "
        "it is less than r - slot width/2 = {:.6g} mm; make the locking radius or the slot width "
        "smaller",
        mm(dimensions.locking_radius), mm(dimensions.slot_width), mm(maximum));
}

}  // namespace

double slot_bottom_centre(const InternalDimensions& dimensions) {
  return dimensions.wheel_diameter / 2. + dimensions.slot_depth - dimensions.slot_width / 2.;
}

void check(const InternalDimensions& dimensions) {
  check_common(dimensions);
  check_slot_depth(dimensions);
  check_neighbouring_slots(dimensions);
  check_rim(dimensions);
  check_locking_arc_meets(dimensions, "inner rim");
  check_locking_arc_clears_slot(dimensions);
}

}  // namespace geneva::loads
