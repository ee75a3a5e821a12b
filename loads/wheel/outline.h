#pragma once

#include <string>
#include <vector>

#include "loads/wheel/geneva_dimensions.h"

namespace geneva::loads {

struct Point {
  double x;
  double y;
};

/// A straight line or a circular arc of less than half a turn, from start to end.
struct Segment {
  Point start;
  Point end;
  bool is_arc;
  Point centre;         ///< of the arc; unused for a line
  bool clockwise;       ///< sense in which the arc runs; unused for a line
  std::string surface;  ///< name of the boundary surface that the segment belongs to
};

/// A closed chain of segments: counter-clockwise around material, clockwise around a hole.
using Loop = std::vector<Segment>;

/// A plane body: the first loop is its outer boundary, the others are its holes.
struct Outline {
  std::string name;
  std::vector<Loop> loops;
};

/// Plane area [m^2], centroid [m] and polar moment of area about the origin [m^4].
struct AreaMoments {
  double area;
  Point centroid;
  double polar_moment;
};

/// Area, centroid and polar moment by Green's theorem, exact on lines and arcs.
///
/// A = 1/2 oint (x dy - y dx); J = 1/4 oint (x^2 + y^2)(x dy - y dx).
/// @throws base::InputError if the loops do not enclose a positive area
AreaMoments area_moments(const Outline& outline);

/// Area within a loop [m^2], negative if it runs clockwise: 1/2 oint (x dy - y dx).
double signed_area(const Loop& loop);

/// Maximum coordinate in size, of all ends of segments [m].
double extent(const std::vector<Outline>& outlines);

/// The wheel in its own frame: axis at the origin, the engaged slot's centre line on +x.
///
/// Surfaces: "driving wall" (the wall at y = +slot_width/2 of the engaged slot, which the pin
/// pushes towards +y while the wheel accelerates, and the slot's whole round bottom, which
/// continues it), "opposite wall" (y = -slot_width/2 of that slot), "slots" (the other slots),
/// "locking arcs", "rim", "bore".
/// @throws base::InputError where check() does
Outline wheel_outline(const GenevaDimensions& dimensions);

/// The pin with its axis at pin_distance [m] along the engaged slot from the wheel's axis, touching
/// the driving wall: a ring of four quarter arcs (the first vertex at the point of contact) with
/// the core as its hole. Surfaces: "pin", "pin core".
/// @throws base::InputError where check() does, or if the pin is not beside the straight wall:
/// between c - r and the end of the wall at sqrt((D/2)^2 - (slot_width/2)^2)
Outline pin_outline(const GenevaDimensions& dimensions, double pin_distance);

/// J = density * thickness * polar moment of area [kg m^2] of the drawn wheel about its axis.
/// @throws base::InputError where check() does, or unless the density is positive and finite
double wheel_inertia(const GenevaDimensions& dimensions, double density);

}  // namespace geneva::loads
