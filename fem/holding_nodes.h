#pragma once

#include <vector>

#include "fem/contact/interface.h"
#include "fem/level.h"

namespace geneva::fem {

/// What every node of every contact does, by interface and row.
using ActiveSets = std::vector<std::vector<NodeStatus>>;

/// Where friction alone holds a body and no node is to stick any more, one does: without it the
/// system would be singular. It is the nearest one to sticking, or, where that stuck alone and
/// carries too much, one that it makes turn.
/// @return whether a node sticks that should not
template <int dim>
bool keep_one_stuck(const Level<dim>& level, const std::vector<ContactState>& states,
                    ActiveSets& next);

/// Where a contact would open wholly that alone holds a body, one of its nodes is closed: without
/// it the system would be singular. It is the one that touches next as the source leaves the node
/// that is pulled least, or else this one.
/// @return whether a node is closed that is pulled
template <int dim>
bool keep_one_closed(const Level<dim>& level, const std::vector<ContactState>& states,
                     ActiveSets& next);

}  // namespace geneva::fem
