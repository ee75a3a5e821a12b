#pragma once

#include <vector>

namespace geneva::fem {

/// Nodes that one coarse node of a multigrid stands for.
struct Aggregates {
  std::vector<int> of_nodes;         ///< number of each node's aggregate; -1: none
  std::vector<unsigned int> bodies;  ///< one entry for each aggregate
};

/// A node that nothing is coupled to, such as one whose unknowns are all given.
inline constexpr int no_aggregate = -1;

/// Damping of the step of Jacobi's method that smooths the motions of aggregates, over the inverse
/// of the largest eigenvalue (Vanek, Mandel and Brezina 1996).
inline constexpr double aggregation_damping = 4. / 3.;

/// Aggregates of coupled nodes (Vanek, Mandel and Brezina 1996, section 5.1): every node none of
/// whose neighbours is taken yet begins one with all of them, what is left joins the aggregate that
/// most of its neighbours are in. No aggregate has nodes of two bodies: bodies in contact slide on
/// each other, which rigid motions of a common aggregate cannot follow.
/// @param neighbours of each node, without itself, of any body; nodes without any get no aggregate
/// @param bodies of each node
/// @param minimum_nodes of an aggregate, 1 or 2; a node that stays alone gets none if it is 2
Aggregates aggregate(const std::vector<std::vector<int>>& neighbours,
                     const std::vector<unsigned int>& bodies, unsigned int minimum_nodes);

}  // namespace geneva::fem
