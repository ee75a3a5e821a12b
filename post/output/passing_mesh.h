#pragma once

#include <vector>

#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"

namespace geneva::post {

/// An instant's fields on a mesh that shows what passes between the instants: cells below wall and
/// pin are divided until they are as small as a share of their depth, or of the contact's width;
/// new nodes round the pin are on its circle. The fields of new nodes are those of the divided
/// cells.
/// @param turning bodies that move with the pin, by index
/// @param curve of the cycle, in the order of the motion
/// @param half_width_per_pressure b/p0 of the contact [m/Pa], > 0
/// @param reach depth to which the contact is missed between the instants [m], >= 0
CycleFields divided_where_passed(const CycleFields& own, const std::vector<bool>& turning,
                                 const std::vector<CycleCurvePoint>& curve,
                                 double half_width_per_pressure, double reach);

}  // namespace geneva::post
