#include "loads/wheel/geneva_dimensions.h"

#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/refuse.h"

namespace geneva::loads {

namespace {

/// The pin presses on the straight wall, so its axis must not come below the bottom's centre.
void check_slot_depth(const GenevaDimensions& dimensions) {
  const double nearest = dimensions.centre_distance - dimensions.crank_radius;
  const double minimum_depth =
      dimensions.wheel_diameter / 2. - nearest + dimensions.slot_width / 2.;
  if (dimensions.slot_depth < minimum_depth - dimension_rounding * dimensions.wheel_diameter)
    refuse(
        "slot depth is {0:.6g} mm: the pin comes as near as {1:.6g} mm to the wheel's axis and "
        "needs a slot of at least {2:.6g} mm; make the slot deeper",
        mm(dimensions.slot_depth), mm(nearest), mm(minimum_depth));
}

/// Slots diverge outwards, so two neighbours are nearest where their bottoms' centres are.
void check_neighbouring_slots(const GenevaDimensions& dimensions) {
  const double spacing = 2. * slot_bottom_centre(dimensions) * std::sin(pi / dimensions.stations);
  if (dimensions.slot_width >= spacing)
    refuse(
        "slot width is {:.6g} mm: neighbouring slots run into each other, since the centres of "
        "their bottoms are {:.6g} mm apart at slot depth {:.6g} mm and the width must be less; "
        "make the slots shallower or narrower, with a thinner pin",
        mm(dimensions.slot_width), mm(std::max(spacing, 0.)), mm(dimensions.slot_depth));
}

void check_bore(const GenevaDimensions& dimensions) {
  require_positive_length("bore radius", dimensions.bore_radius);
  const double lowest = dimensions.wheel_diameter / 2. - dimensions.slot_depth;
  if (dimensions.bore_radius >= lowest)
    refuse(
        "bore radius is {:.6g} mm: the slots come as near as {:.6g} mm to the wheel's axis and the "
        "bore must stay inside; make the bore smaller or the slots shallower",
        mm(dimensions.bore_radius), mm(lowest));
  // Below, the stress at the bore is all that a mesh can follow, and Gmsh takes its points for one.
  constexpr double minimum_share = 1e-4;
  const double least = minimum_share * dimensions.wheel_diameter;
  if (dimensions.bore_radius < least)
    refuse(
        "bore radius is {:.3g} mm: the wheel is held there, and it must be at least {:.3g} mm, a "
        "ten-thousandth of the wheel's diameter; leave it out for one that fits",
        mm(dimensions.bore_radius), mm(least));
}

void check_locking_arc_clears_bore(const GenevaDimensions& dimensions) {
  const double maximum = dimensions.centre_distance - dimensions.bore_radius;
  if (dimensions.locking_radius >= maximum)
    refuse(
        "locking radius is {:.6g} mm: the locking arc cuts into the bore of radius {:.6g} mm "
        "unless it is less than {:.6g} mm; make the locking radius or the bore smaller",
        mm(dimensions.locking_radius), mm(dimensions.bore_radius), mm(maximum));
}

/// Within the rim a locking arc is nearest to the slot where it meets the rim: its centre stands
/// at x = D/2, y = r in the slot's frame, so that y falls along the arc all the way to the rim.
/// A tip of rim left there therefore means that arc and slot are clear of each other. The angle
/// between slot and bisector at the rim is positive, since neighbouring slots are clear already.
void check_tip(const GenevaDimensions& dimensions) {
  const double radius = dimensions.wheel_diameter / 2.;
  const double centres = dimensions.centre_distance;
  const double room =
      pi / dimensions.stations - std::asin(dimensions.slot_width / dimensions.wheel_diameter);
  const double maximum =
      std::sqrt(centres * centres + radius * radius - 2. * centres * radius * std::cos(room));
  if (dimensions.locking_radius >= maximum)
    refuse(
        "locking radius is {:.6g} mm: the locking arc cuts into the slot of width {:.6g} mm (no "
        "tip is left at the rim) unless it is less than {:.6g} mm; make the locking radius or the "
        "slot width smaller",
        mm(dimensions.locking_radius), mm(dimensions.slot_width), mm(maximum));
}

}  // namespace

double slot_bottom_centre(const GenevaDimensions& dimensions) {
  return dimensions.wheel_diameter / 2. - dimensions.slot_depth + dimensions.slot_width / 2.;
}

void check(const GenevaDimensions& dimensions) {
  check_common(dimensions);
  check_slot_depth(dimensions);
  check_neighbouring_slots(dimensions);
  check_bore(dimensions);
  check_locking_arc_meets(dimensions, "rim");
  check_locking_arc_clears_bore(dimensions);
  check_tip(dimensions);
}

}  // namespace geneva::loads
