#include "loads/wheel/common_dimensions.h"

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/refuse.h"

namespace geneva::loads {

namespace {

void check_positive(const CommonDimensions& dimensions) {
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
void check_triangle(const CommonDimensions& dimensions) {
  const double radius = dimensions.wheel_diameter / 2.;
  const double crank = radius * std::tan(pi / dimensions.stations);
  const double centres = radius / std::cos(pi / dimensions.stations);
  const double allowed = dimension_rounding * dimensions.wheel_diameter;
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

void check_pin(const CommonDimensions& dimensions) {
  if (dimensions.pin_diameter >
      dimensions.slot_width + dimension_rounding * dimensions.wheel_diameter)
    refuse(
        "pin diameter is {0:.6g} mm: it must not exceed the slot width {1:.6g} mm; take a pin of "
        "at most {1:.6g} mm or a slot of at least {0:.6g} mm",
        mm(dimensions.pin_diameter), mm(dimensions.slot_width));
  check_core(dimensions.pin_core_radius, dimensions.pin_diameter);
}

}  // namespace

double wall_end(const CommonDimensions& dimensions) {
  const double radius = dimensions.wheel_diameter / 2.;
  const double half_width = dimensions.slot_width / 2.;
  return std::sqrt(radius * radius - half_width * half_width);
}

/// By half the angle: the arc cosine of a small one would lose digits.
double locking_half_angle(const CommonDimensions& dimensions) {
  const double radius = dimensions.wheel_diameter / 2.;
  const double centres = dimensions.centre_distance;
  const double reach = centres - radius;
  const double squares = (dimensions.locking_radius - reach) * (dimensions.locking_radius + reach);
  return 2. * std::asin(std::sqrt(squares / (4. * centres * radius)));
}

void check_core(double core_radius, double pin_diameter) {
  if (core_radius >= pin_diameter / 2.)
    refuse(
        "pin core radius is {:.6g} mm: the core must lie inside the pin of radius {:.6g} mm; make "
        "the core smaller or the pin larger",
        mm(core_radius), mm(pin_diameter / 2.));
}

void check_common(const CommonDimensions& dimensions) {
  require_stations(dimensions.stations);
  check_positive(dimensions);
  check_triangle(dimensions);
  check_pin(dimensions);
}

void check_locking_arc_meets(const CommonDimensions& dimensions, const char* rim) {
  const double least = dimensions.centre_distance - dimensions.wheel_diameter / 2.;
  if (dimensions.locking_radius <= least)
    refuse(
        "locking radius is {:.6g} mm: the locking arc misses the {} unless it is greater than "
        "c - D/2 = {:.6g} mm; make the locking radius larger",
        mm(dimensions.locking_radius), rim, mm(least));
}

}  // namespace geneva::loads
