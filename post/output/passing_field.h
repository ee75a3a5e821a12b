#pragma once

#include <vector>

#include "post/output/cycle_fields.h"
#include "post/output/envelope.h"
#include "post/output/passing_pressure.h"

namespace geneva::post {

/// What the field of the contact between pin and wall depends on.
struct PassingMaterials {
  double half_width_per_pressure;       ///< b/p0 [m/Pa]
  double friction;                      ///< mu of the wall, >= 0
  std::vector<double> poissons_ratios;  ///< by body
};

/// How deep below wall and pin the fields of the instants miss a contact that passes between them
/// [m]: beside an instant by delta a load's stress at the depth z is 1/(1 + (delta/z)^2) of that
/// below it, nine tenths at three times half of the greatest way between two instants; at least
/// four half-widths.
/// @param pin_distances of the instants of one wall, in any order [m]
/// @param half_width greatest b [m]
double missed_depth(std::vector<double> pin_distances, double half_width);

/// Raises the envelope at every node to what the contact's own field is there at most while it
/// passes: the stress of a half-space in plane strain under Hertz's pressure that slides, see
/// loads::sliding_stress().
/// @param greatest at the nodes of an instant with a contact
/// @param passing at the same nodes, down to the depth that is to be raised
void raise_to_passing_field(Envelope& greatest, const NodalFields& fields,
                            const PassingContact& passing, const PassingMaterials& materials);

}  // namespace geneva::post
