#include "model/mechanism_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/locking_disc.h"
#include "loads/wheel/outline.h"
#include "loads/wheel/outline_shapes.h"
#include "model/pin_in_space.h"

namespace geneva::model {

namespace {

using loads::Extrusion;
using loads::Outline;
using loads::Point;
using loads::SlotSide;
using loads::SolidPart;

/// What the parts have in common.
struct Layout {
  SlotSide side;
  loads::CommonDimensions sizes;
  std::vector<double> pins;  ///< where they stand on the driver, counter-clockwise [rad]
  double bottom;             ///< of the pins [m]
  double root;               ///< where the driver's plate begins, above the wheel [m]
  double top;                ///< of plate and pins [m]
};

/// Free length of a pin whose root gap is not given, over its diameter.
constexpr double plane_root_gap = 0.25;

bool is_outside(const DrawnWheel& wheel) {
  return std::holds_alternative<loads::GenevaDimensions>(wheel);
}

Layout layout_of(const MechanismCase& given, const MechanismDynamics& dynamics) {
  if (!dynamics.wheel)
    throw base::InputError(
        "the whole wheel of this type is not known, so that there is nothing to draw: external and "
        "internal wheels are drawn");
  Layout layout{};
  layout.side = is_outside(*dynamics.wheel) ? SlotSide::outside : SlotSide::inside;
  layout.sizes = std::visit([](const auto& wheel) -> loads::CommonDimensions { return wheel; },
                            *dynamics.wheel);
  // A pin that is engaged later by the driver angle stands that angle behind.
  const double sense = layout.side == SlotSide::outside ? 1. : -1.;
  const auto mechanism = mechanism_of(given);
  const std::vector<double> angles = given.pin_angles.empty()
                                         ? loads::equally_spaced_pins(mechanism, given.pins)
                                         : given.pin_angles;
  for (const double angle : angles) layout.pins.push_back(sense * angle);
  const double half = layout.sizes.thickness / 2.;
  const PinLengths free = given.space ? pin_lengths(given, dynamics.sizes)
                                      : PinLengths{plane_root_gap * layout.sizes.pin_diameter, 0.};
  layout.bottom = -half - free.overhang;
  layout.root = half + free.root_gap;
  layout.top = layout.root + layout.sizes.thickness;
  return layout;
}

Outline wheel_outline_of(const DrawnWheel& wheel) {
  if (const auto* external = std::get_if<loads::GenevaDimensions>(&wheel))
    return loads::wheel_outline(*external);
  return loads::internal_wheel_outline(std::get<loads::InternalDimensions>(wheel));
}

Outline disc(const std::string& name, const double diameter) {
  return {name, {loads::circle({0., 0.}, diameter / 2., false, name)}};
}

Point pin_place(const Layout& layout, const double angle) {
  return loads::rotated({layout.sizes.crank_radius, 0.}, angle);
}

/// @param hole diameter of the holes for pins [m]
Outline plate(const Layout& layout, const double hole) {
  Outline outline = disc("plate", 2. * (layout.sizes.crank_radius + layout.sizes.pin_diameter));
  for (const double angle : layout.pins)
    outline.loops.push_back(loads::circle(pin_place(layout, angle), hole / 2., true, "pin hole"));
  return outline;
}

/// Of the driver in the frame of the mechanism: the first pin points at the wheel's axis, or away
/// from it, midway through its engagement.
loads::Placement driver_placement(const Layout& layout, const double driver_angle) {
  const double angle = layout.side == SlotSide::outside ? loads::pi - driver_angle : driver_angle;
  return {angle, {layout.sizes.centre_distance, 0.}};
}

SolidPart driver(const Layout& layout, const double hole, const loads::Placement& placement,
                 std::vector<std::string>& notices) {
  SolidPart part{"driver", {{plate(layout, hole), layout.root, layout.top}}, placement};
  const double half = layout.sizes.thickness / 2.;
  auto lock = loads::locking_disc(layout.sizes, layout.side, layout.pins);
  if (!lock) {
    notices.emplace_back(
        "the driver is drawn without a locking disc: between its pins no dwell is left in which "
        "one could lock");
    return part;
  }
  const double late = lock->half_cut - loads::half_engagement(layout.sizes, layout.side);
  if (late > 0.)
    notices.push_back(fmt::format(
        "the wheel's tips need a wider cut-out of the locking disc: it lets go of the wheel {:.3g} "
        "deg of the driver before the pin is in its slot; a larger 'Locking radius' avoids that",
        late / loads::degree));
  part.extrusions.push_back({std::move(lock->outline), -half, layout.root});
  return part;
}

/// Diameter of the pin where the driver holds it: that of a roller's stud.
double held_diameter(const MechanismCase& given, const Layout& layout) {
  if (!given.roller) return layout.sizes.pin_diameter;
  return given.roller->stud() - given.bore_clearance.value_or(0.);
}

std::vector<SolidPart> pin_parts(const MechanismCase& given, const Layout& layout,
                                 const loads::Placement& placement) {
  const double half = layout.sizes.thickness / 2.;
  Outline section = disc("pin", held_diameter(given, layout));
  if (const auto bore = given.pin_holding.bore_diameter)
    section.loops.push_back(loads::circle({0., 0.}, *bore / 2., true, "pin bore"));
  SolidPart pin{
      given.roller ? "stud" : "pin", {{std::move(section), layout.bottom, layout.top}}, placement};
  if (!given.roller) return {pin};
  Outline ring = disc("pin", layout.sizes.pin_diameter);
  ring.loops.push_back(loads::circle({0., 0.}, given.roller->diameter / 2., true, "roller bore"));
  return {{"roller", {{std::move(ring), -half, half}}, placement}, std::move(pin)};
}

/// Of a slot from the line of centres [rad]; while the wheel rests two slots stand half a pitch
/// from it.
double wheel_angle(const MechanismCase& given, const double driver_angle) {
  const loads::Mechanism mechanism = mechanism_of(given);
  const auto engagements = engagements_of(given, mechanism);
  const double begin = loads::cycle_begin(mechanism, engagements);
  const double period = mechanism.period;
  const double angle = driver_angle - period * std::floor((driver_angle - begin) / period);
  for (const loads::Engagement& engagement : engagements)
    if (angle >= engagement.begin && angle <= engagement.end)
      return mechanism.motion(angle - engagement.middle).wheel_angle.value;
  return loads::half_pitch(mechanism);
}

}  // namespace

MechanismParts mechanism_parts(const MechanismCase& given, const double driver_angle) {
  const MechanismDynamics dynamics = mechanism_dynamics(given);
  const Layout layout = layout_of(given, dynamics);
  const double half = layout.sizes.thickness / 2.;
  MechanismParts result;
  result.parts.push_back({"wheel",
                          {{wheel_outline_of(*dynamics.wheel), -half, half}},
                          {wheel_angle(given, driver_angle), {0., 0.}}});
  const loads::Placement placement = driver_placement(layout, driver_angle);
  result.parts.push_back(driver(layout, held_diameter(given, layout), placement, result.notices));
  for (const double pin : layout.pins) {
    const double angle = placement.angle + pin;
    const Point arm = loads::rotated({layout.sizes.crank_radius, 0.}, angle);
    const loads::Placement at{angle, {placement.origin.x + arm.x, placement.origin.y + arm.y}};
    for (SolidPart& part : pin_parts(given, layout, at)) result.parts.push_back(std::move(part));
  }
  return result;
}

}  // namespace geneva::model
