#pragma once

#include "loads/wheel/geneva_dimensions.h"
#include "loads/wheel/internal_dimensions.h"

namespace geneva::loads {

/// The thinnest part of a wheel's plate.
struct LeastWall {
  double thickness;     ///< [m]
  const char* between;  ///< what it separates
};

/// The least of the tip between slot and locking arc at the rim, R sin(pi/n - lambda) - w/2 with
/// half the locking arc's angle lambda; of the webs between neighbouring slots; and of what is left
/// between bore and slots or locking arcs.
/// @throws base::InputError where check() does
LeastWall least_wall(const GenevaDimensions& dimensions);

/// The least of the arm between slot and locking arc, r - w/2 less the locking radius; and of what
/// is left between the outer rim and slots or locking arcs.
/// @throws base::InputError where check() does
LeastWall least_wall(const InternalDimensions& dimensions);

}  // namespace geneva::loads
