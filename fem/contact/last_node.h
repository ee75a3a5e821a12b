#pragma once

#include <algorithm>

namespace geneva::fem {

/// The contact of a mesh acts as one that is made to end so many edges beyond its last active node.
/// Measured as the next, see doc/theory.md, 4.6.
constexpr double end_beyond_last_node = 0.19;

/// By how many edges a contact of a mesh ends too far outwards, told by the pressure of its last
/// node: half an edge where it has just closed, minus half an edge where the next one is about to.
/// In between the pressure is proportional to what is left, within 4 %: measured on a cylinder on a
/// cylinder under 52 loads, with 13 to 35 nodes.
/// @param relative_pressure of the last node, over K h^(1/2) where the pressure falls as
/// K d^(1/2) with the distance d from its end: K = p0 (2/a)^(1/2) after Hertz
/// @return from -0.5 to 0.5
inline double shift_of_end(const double relative_pressure) {
  constexpr double of_closing_node = 0.825;
  return std::clamp(0.5 - relative_pressure / of_closing_node, -0.5, 0.5);
}

}  // namespace geneva::fem
