#pragma once

namespace geneva::loads {

/// Dimensions that external and internal Geneva wheels and their pins share; lengths in metres.
struct CommonDimensions {
  int stations;            ///< n, 3..24
  double wheel_diameter;   ///< D of the cylinder on which the slots open
  double crank_radius;     ///< r = (D/2) tan(pi/n)
  double centre_distance;  ///< c = (D/2)/cos(pi/n)
  double pin_diameter;     ///< d
  double thickness;        ///< t of the wheel
  double slot_width;       ///< between the parallel walls, not less than d
  double slot_depth;       ///< from radius D/2 to the farthest point of the semicircular bottom
  double locking_radius;   ///< R of the locking arcs, centred at distance c midway between slots
  double pin_core_radius;  ///< of the pin's core, where the driver holds it
};

/// Lengths that agree to this fraction of the wheel's diameter count as equal: well above rounding
/// of derived dimensions, well below any tolerance of manufacture.
constexpr double dimension_rounding = 1e-9;

/// Where the slot walls meet the cylinder of radius D/2, along the slot's centre line [m].
double wall_end(const CommonDimensions& dimensions);

/// Half the angle [rad] that a locking arc takes out of the cylinder of radius D/2, seen from the
/// wheel's axis.
double locking_half_angle(const CommonDimensions& dimensions);

/// @throws base::InputError unless the pin's core is inside the pin; lengths in metres
void check_core(double core_radius, double pin_diameter);

/// Checks what does not depend on the side on which the slots open.
///
/// Refused: stations outside 3..24; lengths not positive and finite; crank radius or centre
/// distance that do not belong to the wheel diameter; pin wider than the slot; core not inside the
/// pin.
/// @throws base::InputError with the numbers that clash and what to change
void check_common(const CommonDimensions& dimensions);

/// @param rim what the cylinder of radius D/2 is called
/// @throws base::InputError unless the locking arcs cut into the cylinder of radius D/2
void check_locking_arc_meets(const CommonDimensions& dimensions, const char* rim);

}  // namespace geneva::loads
