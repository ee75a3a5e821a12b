#pragma once

namespace geneva::loads {

/// Dimensions of an external Geneva wheel and its pin; lengths in metres.
struct GenevaDimensions {
  int stations;            ///< n, 3..24
  double wheel_diameter;   ///< D
  double crank_radius;     ///< r = (D/2) tan(pi/n)
  double centre_distance;  ///< c = (D/2)/cos(pi/n)
  double pin_diameter;     ///< d
  double thickness;        ///< t of the wheel
  double slot_width;       ///< between the parallel walls, not less than d
  double slot_depth;  ///< from the rim (radius D/2) to the lowest point of the semicircular bottom
  double locking_radius;   ///< R of the locking arcs, centred at distance c midway between slots
  double bore_radius;      ///< of the hole at the wheel's axis
  double pin_core_radius;  ///< of the pin's core, where the driver holds it
};

/// Radius of the centre of the slots' semicircular bottom: D/2 - slot_depth + slot_width/2 [m].
double slot_bottom_centre(const GenevaDimensions& dimensions);

/// Checks that the proportions make one connected wheel with room for the pin.
///
/// Refused: stations outside 3..24; lengths not positive and finite; crank radius or centre
/// distance that do not belong to the wheel diameter; pin wider than the slot; core not inside the
/// pin; slot that does not reach the pin's nearest position; slot into bore, slots into each other,
/// locking arc into slot, locking arc into bore, locking arc that misses the rim.
/// @throws std::invalid_argument with the numbers that clash and what to change
void check(const GenevaDimensions& dimensions);

}  // namespace geneva::loads
