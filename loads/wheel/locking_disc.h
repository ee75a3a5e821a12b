#pragma once

#include <optional>
#include <vector>

#include "loads/wheel/common_dimensions.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

/// The side on which the slots open, away from the wheel's axis or towards it.
enum class SlotSide { outside, inside };

/// The disc on the driver that fits into a locking arc while the wheel rests.
struct LockingDisc {
  Outline outline;
  double half_cut;  ///< how far a cut-out reaches to both sides of its pin on the rim [rad]
};

/// How far the pin's engagement reaches to both sides of the line of centres, pi/2 -+ pi/n [rad]: a
/// disc with cut-outs of this width locks until the pin is in its slot.
double half_engagement(const CommonDimensions& dimensions, SlotSide side);

/// The disc has the radius R of the locking arcs, and for each pin a cut-out through which the
/// wheel's tips pass, whose way is followed. The cut-out reaches over the engagement, or as much
/// further as the tips need. Inside it is bounded by one circular arc about a point on the pin's
/// line: the circle about the wheel's axis midway through the engagement, or the next deeper one
/// that lets the tips pass.
///
/// In the driver's frame: axis at the origin, the first pin on +x. Surfaces: "locking disc",
/// "cut-out".
/// @param pin_angles where the pins stand, counter-clockwise from the first [rad]
/// @return none if no dwell is left between the cut-outs in which a disc could lock
std::optional<LockingDisc> locking_disc(const CommonDimensions& dimensions, SlotSide side,
                                        const std::vector<double>& pin_angles);

}  // namespace geneva::loads
