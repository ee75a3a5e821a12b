#pragma once

#include <vector>

#include "fem/contact/contact_result.h"

namespace geneva::fem {

/// Top of a contact's pressure in the plane.
struct FittedPeak {
  double pressure;   ///< [Pa]; that of the nodes, freed from their scatter
  double averaging;  ///< share of it that is lost since nodes stand for a mean over their edges
  double scatter;  ///< by how much it may be off by the nodes' distances from the parabola, with a
                   ///< probability of 95 %; relative
};

/// The top of the parabola through p^2, which Hertz's p^2 is, fitted to the nodes around the
/// maximum one that carry nine tenths of it, at least five, weighted with what they stand for (next
/// to an axis of revolution that is next to nothing, and the pressure is 1 to 2 % off there). At
/// the end of the surface the parabola is even. Where fewer than two nodes on either side of the
/// maximum one are closed, or where the parabola opens upwards, the maximum node.
///
/// A node's pressure is the mean of p over its hat function of half-width h, which is p + p''
/// h^2/12 to second order: p0 (1 - 1/(3 N^2)) on top of Hertz's pressure over N edges.
FittedPeak fitted_peak(const std::vector<ContactNode<2>>& nodes);

/// What the ends of a contact are worth, relative to its peak pressure.
struct EndShare {
  double share;  ///< >= 0, by which it is too much
  double doubt;  ///< >= 0, of that share
};

/// Share of a line contact's peak pressure that is too much because each of its free ends lies at a
/// node and not where the pressure would end: sum of (d/h)^2/N^2 over the ends, h being the edges.
///
/// A contact that has to end at distances a + d1 and a + d2 from its middle instead of at a carries
/// p(x) = p0 (a^2 + c^2 - 2 (x - s)^2 - 2 s (x - s))/(2 a sqrt(c^2 - (x - s)^2)) with
/// c = a + (d1 + d2)/2 and s = (d1 - d2)/2, whose maximum is p0 (1 + (d1^2 + d2^2)/(4 a^2)); see
/// doc/theory.md, 4.6. How far an end is off is told by its last node, see free_end(); its doubt is
/// what would change if the parabola were right.
///
/// @param contact with its intervals; the end of a symmetric one counts twice
/// @return 0 where the pressure peaks beside an end or without free ends; no doubt is known with
/// fewer than 8 nodes
EndShare share_of_free_ends(const ContactResult<2>& contact);

/// The target's edges under a contact.
struct TargetEdges {
  double ratio;  ///< of their mean length to that of the source's edges, > 0
  double share;  ///< of the target's body in the compliance of both, 0..1
};

/// Share of a line contact's peak pressure that is too much because the target's edges are longer
/// than the source's, at whose ends share_of_free_ends() is measured: 0.2 share (ratio^2 -
/// 1)/N^2, negative where they are shorter; see doc/theory.md, 4.6.
/// @return 0 where share_of_free_ends() knows nothing
double share_of_target(const ContactResult<2>& contact, const TargetEdges& target);

/// Frees the peak pressure of a line contact from all three.
void correct_for_nodes(ContactResult<2>& contact, const TargetEdges& target);

}  // namespace geneva::fem
