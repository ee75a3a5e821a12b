#pragma once

#include <string>

#include "fem/solution.h"
#include "post/analysis/stress.h"

namespace geneva::post {

/// A round pin along z in a solution, and what bends it.
struct PinPlace {
  std::string body;
  double x;  ///< of its axis [m]
  double y;
  double diameter;               ///< [m]
  double tip;                    ///< z of the free end; of a pin held twice its middle [m]
  double middle;                 ///< z of the middle of the wheel [m]
  double root;                   ///< z of the end where it is held, above the wheel [m]
  double free_length;            ///< from the root to the wheel [m]
  std::string root_surface;      ///< that holds it
  bool held_at_both_ends;        ///< by that surface
  bool is_half;                  ///< only z > middle is modelled, by symmetry
  fem::Components<3> direction;  ///< of the force that its holder exerts, unit vector
};

/// How a pin bends; SI units.
struct PinBending {
  double tip_deflection;  ///< mean displacement of the section at the tip against the force, less
                          ///< that of the root [m]
  double slope;           ///< turn of the cross-section in the middle of the wheel [rad]
  double root_stress;     ///< bending stress at the root [Pa]
  double section_moment;  ///< second moment of area of the meshed cross-section over the circle's,
                          ///< mean over the free length
};

/// Over all ranks. Each value is a least-squares fit over the cells of a slice of the pin: the
/// stress concentration of a clamped face does not enter. Where the free length is less than half
/// the diameter, no section bears a beam's stress; a pin held at one end then gets the stress
/// 32 M/(pi d^3) that belongs to the moment of its reaction.
PinBending pin_bending(const fem::Solution<3>& solution, const PinPlace& pin,
                       const std::vector<CellStress<3>>& cells);

}  // namespace geneva::post
