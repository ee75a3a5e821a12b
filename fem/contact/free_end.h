#pragma once

#include <optional>
#include <vector>

#include "fem/contact/contact_result.h"

namespace geneva::fem {

/// Where a plane contact would end if it did not have to end at a node; in edges of the mesh there.
struct FreeEnd {
  double by_parabola;   ///< beyond the last active node: the zero of the parabola through p^2
  double by_last_node;  ///< the same as the pressure of that node tells
  double shift;         ///< by which the contact of the mesh ends too far outwards: -0.5 to 0.5
};

/// Between smooth bodies p^2 is a smooth function of the place up to the end of the contact (a
/// parabola after Hertz). A parabola is fitted to this half of the contact without its last node.
/// Its slope K^2 at its zero tells that the pressure falls as K d^(1/2) with the distance d from
/// the end.
///
/// The contact of a mesh acts as one that is made to end 0.19 edges h beyond its last active node.
/// That is half an edge too far where this node has just closed, and half an edge short where the
/// next one is about to; in between the pressure is 0.825 K h^(1/2) times what is left of the edge,
/// within 4 %. Measured on a cylinder on a cylinder under 52 loads, with 13 to 35 nodes; see
/// doc/theory.md, 4.6.
///
/// @param edge the last active node
/// @param inwards the step to the next one: 1 or -1; there is an open node beyond `edge`
/// @param count active nodes in a row from there
/// @return nothing with fewer than 8 nodes, or where the parabola has no zero
std::optional<FreeEnd> free_end(const std::vector<ContactNode<2>>& nodes, std::size_t edge,
                                int inwards, std::size_t count);

/// The shift of a FreeEnd by the last node's pressure over K h^(1/2).
double shift_by_last_node(double relative_pressure);

}  // namespace geneva::fem
