#include "loads/geneva_dimensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Lengths that agree to this fraction of the wheel's diameter count as equal: well above rounding
/// of derived dimensions, well below any tolerance of manufacture.
const double rounding = 1e-9;

double mm(double metres) { return 1e3 * metres; }

template <typename... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> message, Values... values) {
  throw std::invalid_argument(fmt::format(message, values...));
}

/// All but the bore, whose default comes from the slot and is judged after it.
void check_positive(const GenevaDimensions& dimensions) {
  require_positive_length("wheel diameter", dimensions.wheel_diameter);
  require_positive_length("crank radius", dimensions.crank_radius);
  require_positive_length("centre distance", dimensions.centre_distance);
  require_positive_length("pin diameter", dimensions.pin_diameter);
  require_positive_length("thickness", dimensions.thickness);
  require_positive_length("slot width", dimensions.slot_width);
  require_positive_length("slot depth", dimensions.slot_depth);
  require_positive_length("locking radius", dimensions.locking_radius);
  require_positive_length("pin core radius", dimensions.pin_core_radius);
}

/// The pin enters along the slot only if the triangle of axes and pin is right-angled at entry.
void check_triangle(const GenevaDimensions& dimensions) {
  const double radius = dimensions.wheel_diameter / 2.;
  const double crank = radius * std::tan(pi / dimensions.stations);
  const double centres = radius / std::cos(pi / dimensions.stations);
  const double allowed = rounding * dimensions.wheel_diameter;
  if (std::abs(dimensions.crank_radius - crank) > allowed)
    refuse(
        "crank radius is {:.9g} mm: {} stations and wheel diameter {:.6g} mm need (D/2) tan(pi/n) "
        "= {:.9g} mm; change the crank radius or the wheel diameter",
        mm(dimensions.crank_radius), dimensions.stations, mm(dimensions.wheel_diameter), mm(crank));
  if (std::abs(dimensions.centre_distance - centres) > allowed)
    refuse(
        "centre distance is {:.9g} mm: {} stations and wheel diameter {:.6g} mm need "
        "(D/2)/cos(pi/n) = {:.9g} mm; change the centre distance or the wheel diameter",
        mm(dimensions.centre_distance), dimensions.stations, mm(dimensions.wheel_diameter),
        mm(centres));
}

void check_pin(const GenevaDimensions& dimensions) {
  if (dimensions.pin_diameter > dimensions.slot_width + rounding * dimensions.wheel_diameter)
    refuse(
        "pin diameter is {0:.6g} mm: it must not exceed the slot width {1:.6g} mm; take a pin of "
        "at most {1:.6g} mm or a slot of at least {0:.6g} mm",
        mm(dimensions.pin_diameter), mm(dimensions.slot_width));
  if (dimensions.pin_core_radius >= dimensions.pin_diameter / 2.)
    refuse(
        "pin core radius is {:.6g} mm: the core must lie inside the pin of radius {:.6g} mm; make "
        "the core smaller or the pin larger",
        mm(dimensions.pin_core_radius), mm(dimensions.pin_diameter / 2.));
}

/// The pin presses on the straight wall, so its axis must not come below the bottom's centre.
void check_slot_depth(const GenevaDimensions& dimensions) {
  const double nearest = dimensions.centre_distance - dimensions.crank_radius;
  const double least_depth = dimensions.wheel_diameter / 2. - nearest + dimensions.slot_width / 2.;
  if (dimensions.slot_depth < least_depth - rounding * dimensions.wheel_diameter)
    refuse(
        "slot depth is {0:.6g} mm: the pin comes as near as {1:.6g} mm to the wheel's axis and "
        "needs a slot of at least {2:.6g} mm; make the slot deeper",
        mm(dimensions.slot_depth), mm(nearest), mm(least_depth));
}

/// Slots diverge outwards, so two neighbours are nearest where their bottoms' centres are.
void check_neighbouring_slots(const GenevaDimensions& dimensions) {
  const double spacing = 2. * slot_bottom_centre(dimensions) * std::sin(pi / dimensions.stations);
  if (dimensions.slot_width >= spacing)
    refuse(
        "slot width is {:.6g} mm: neighbouring slots run into each other, since the centres of "
        "their bottoms are {:.6g} mm apart at slot depth {:.6g} mm and the width must be less; "
        "make the slots narrower or shallower",
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
}

void check_locking_arc_reach(const GenevaDimensions& dimensions) {
  const double least = dimensions.centre_distance - dimensions.wheel_diameter / 2.;
  if (dimensions.locking_radius <= least)
    refuse(
        "locking radius is {:.6g} mm: the locking arc misses the rim unless it is greater than "
        "c - D/2 = {:.6g} mm; make the locking radius larger",
        mm(dimensions.locking_radius), mm(least));
  const double greatest = dimensions.centre_distance - dimensions.bore_radius;
  if (dimensions.locking_radius >= greatest)
    refuse(
        "locking radius is {:.6g} mm: the locking arc cuts into the bore of radius {:.6g} mm "
        "unless it is less than {:.6g} mm; make the locking radius or the bore smaller",
        mm(dimensions.locking_radius), mm(dimensions.bore_radius), mm(greatest));
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
  const double greatest =
      std::sqrt(centres * centres + radius * radius - 2. * centres * radius * std::cos(room));
  if (dimensions.locking_radius >= greatest)
    refuse(
        "locking radius is {:.6g} mm: the locking arc cuts into the slot of width {:.6g} mm (no "
        "tip is left at the rim) unless it is less than {:.6g} mm; make the locking radius or the "
        "slot width smaller",
        mm(dimensions.locking_radius), mm(dimensions.slot_width), mm(greatest));
}

}  // namespace

double slot_bottom_centre(const GenevaDimensions& dimensions) {
  return dimensions.wheel_diameter / 2. - dimensions.slot_depth + dimensions.slot_width / 2.;
}

void check(const GenevaDimensions& dimensions) {
  require_stations(dimensions.stations);
  check_positive(dimensions);
  check_triangle(dimensions);
  check_pin(dimensions);
  check_slot_depth(dimensions);
  check_neighbouring_slots(dimensions);
  check_bore(dimensions);
  check_locking_arc_reach(dimensions);
  check_tip(dimensions);
}

}  // namespace geneva::loads
