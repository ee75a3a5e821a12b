#pragma once

#include <vector>

#include "fem/contact/interface.h"

namespace geneva::fem {

/// The active rows but those where the pressure is smooth: the zone whose resolution decides.
template <int dim>
std::vector<bool> zone_rows(const ContactInterface<dim>& interface);

/// Which nodes of the source belong to the zone.
template <int dim>
std::vector<bool> zone_nodes(const ContactInterface<dim>& interface);

/// Where nodes lie so close that the pressure between the neighbours of each is off the straight
/// line by a small share of the peak at most, so that finer edges would change nothing: the middle
/// of a wide contact whose pressure peaks at its ends. None if that is the whole contact, or less
/// than three quarters of it.
/// @param tolerance that share, > 0
ArcIntervals smooth_intervals(const ContactInterface<2>& interface, const ContactState& state,
                              double tolerance);

/// Whether the maximum pressure stands within four edges of an end or a corner of the source, or
/// over one of the target.
bool peaks_at_corner(const ContactInterface<2>& interface, const ContactState& state);

/// How many active nodes the contact is wide: all of them in the plane; in 3-D twice the most
/// steps from an active node to an open one, less one.
unsigned int nodes_across(const ContactInterface<2>& interface);
unsigned int nodes_across(const ContactInterface<3>& interface);

/// The target's mean edge over the source's, where the contact is closed; 1 where it has no edge on
/// one of them.
double ratio_of_edges(const ContactInterface<2>& interface);

/// Arc-length intervals of the source surface covered by the nodes of the zone.
ArcIntervals zone_intervals(const ContactInterface<2>& interface);

}  // namespace geneva::fem
