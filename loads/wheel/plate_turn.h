#pragma once

#include <functional>

#include "loads/hertz.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

/// A plane plate of constant thickness, held somewhere.
struct HeldPlate {
  Outline outline;
  std::function<bool(Point)> is_held;  ///< the plate neither moves nor turns there
  std::vector<Point> marks;            ///< where details of the hold are, on lines of the grid
  double thickness;                    ///< t [m]
  Elastic material;
};

/// By how much the normal of a plate turns in the plane x = const. on its edge, in the mean over a
/// length of t, under a moment in that plane that is spread evenly over this length: nearer to the
/// load it is no plate.
///
/// Reissner and Mindlin's plate (Mindlin 1951, shear correction 5/6) with bilinear elements and
/// the shear at their middle (Hughes, Taylor and Kanoknukulchai 1977), on a grid of rectangles that
/// grow away from the place from t/6 on; those that the outline cuts have the stiffness of their
/// part inside.
/// @param place in the middle of that length; on an edge that runs along x, with material above it
/// @return [rad/(N m)], > 0
/// @throws base::InputError if the plate is not held
double plate_turn(const HeldPlate& plate, Point place);

}  // namespace geneva::loads
