#pragma once

#include "loads/motion/four_bar.h"

namespace geneva::loads {

/// What the two-position synthesis of a crank-rocker starts from.
struct CrankRockerInput {
  double swing;           ///< angle between the rocker's extreme positions [rad], 0 < swing < pi
  double rocker;          ///< O_4 B > 0 [m]
  double pivot_distance;  ///< O_2 from the middle of B_1 B_2 along the extended chord [m], greater
                          ///< than half the chord, rocker sin(swing/2)
};

/// Crank-rocker whose rocker goes forward and back in equal times (k_t = 1).
///
/// Frame: origin at the rocker's pivot D (the lecture's O_4), x along the chord B_1 B_2, the middle
/// of the chord at (0, CD cos(swing/2)); the crank's pivot A (O_2) lies at x = -pivot_distance on
/// the chord's line. The lecture's A and B are the linkage's B and C.
struct CrankRocker {
  FourBar linkage;    ///< coupler point P = C
  Assembly assembly;  ///< open: the rocker's end above the frame
  double swing;       ///< [rad]
  double far_crank;   ///< crank angle [rad] at which the rocker is farthest from A: 0
  double near_crank;  ///< crank angle [rad] at which it is nearest: pi
  double frame;       ///< AD [m]
  double minimum_transmission_angle;  ///< between coupler and rocker [rad], at most pi/2
};

/// Lecture 4's construction in closed form: crank AB = CD sin(swing/2), half the chord; coupler BC
/// = pivot_distance; AD^2 = BC^2 + CD^2 - AB^2. Grashof's condition holds if and only if O_2 lies
/// outside the chord.
///
/// The transmission angle is least where the crank lies along AD: cos(mu) = AB AD/(BC CD); it grows
/// with the pivot's distance towards pi/2 - swing/2.
/// @throws base::InputError unless 0 < swing < pi, the rocker is positive and finite and the
/// distance of the pivot is finite and greater than half the chord
CrankRocker crank_rocker(const CrankRockerInput& input);

}  // namespace geneva::loads
