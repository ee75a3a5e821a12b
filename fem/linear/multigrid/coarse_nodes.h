#pragma once

#include <deal.II/base/point.h>

#include <vector>

#include "fem/linear/multigrid/aggregation.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// Coarse nodes, each in the middle of the aggregate of nodes that it stands for, as these nodes
/// see them.
template <int dim>
struct CoarseNodes {
  std::vector<int> of_nodes;  ///< number among those of all ranks, of each place's node
  std::vector<dealii::Point<dim>> centres;      ///< of the coarse node of each place's node
  std::vector<dealii::Point<dim>> own_centres;  ///< of this rank's coarse nodes
  UnknownRanges unknowns;  ///< as many of each as there are rigid motions, numbered rank by rank
};

/// @param aggregates of this rank's nodes
/// @param positions of the nodes of all places
/// @param pattern by which the nodes are coupled
template <int dim>
CoarseNodes<dim> coarse_nodes(const Aggregates& aggregates,
                              const std::vector<dealii::Point<dim>>& positions,
                              const NodePattern& pattern);

/// Points of the nodes of all places from those of the own ones.
template <int dim>
std::vector<dealii::Point<dim>> on_all_nodes(const std::vector<dealii::Point<dim>>& of_own_nodes,
                                             const NodePattern& pattern);

}  // namespace geneva::fem
