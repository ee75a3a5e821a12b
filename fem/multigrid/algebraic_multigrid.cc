#include "fem/multigrid/algebraic_multigrid.h"

#include <ml_include.h>

#include <ml_agg_user.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "fem/multigrid/aggregation.h"

namespace geneva::fem {

namespace {

/// Bodies of this rank's nodes on the level that ML coarsens next. ML hands its callbacks nothing
/// of the caller's, so that this cannot be an argument.
thread_local std::vector<unsigned int> bodies_of_level;

/// Neighbours of this rank's nodes on this rank; a node with unknowns of its own that only other
/// ranks' nodes are coupled to is its own neighbour.
std::vector<std::vector<int>> neighbours_of_nodes(ML_Operator* matrix, int* n_entries) {
  const int n_nodes = matrix->outvec_leng;
  std::vector<std::vector<int>> result(static_cast<std::size_t>(n_nodes));
  std::vector<int> columns(256);
  std::vector<double> values(columns.size());
  for (int node = 0; node < n_nodes; ++node) {
    int count = 0;
    while (ML_Operator_Getrow(matrix, 1, &node, static_cast<int>(columns.size()), columns.data(),
                              values.data(), &count) == 0) {
      columns.resize(2 * columns.size());
      values.resize(columns.size());
    }
    *n_entries += count;
    auto& neighbours = result[static_cast<std::size_t>(node)];
    std::copy_if(columns.begin(), columns.begin() + count, std::back_inserter(neighbours),
                 [&](const int other) { return other != node && other < n_nodes; });
    if (neighbours.empty() && count > 1) neighbours.push_back(node);
  }
  return result;
}

}  // namespace

// What ML calls, with the types that it asks for.
extern "C" {

static char* label_of_aggregation() {
  static std::array<char, 16> label{"within bodies"};
  return label.data();
}

static int aggregate_within_bodies(ML_Operator* matrix, char* is_given, double, double*, double*,
                                   double*, int* of_nodes, int* n_entries) {
  *n_entries = 0;
  std::fill_n(is_given, matrix->outvec_leng, 'F');  // the modes have zeros for given values already
  Aggregates aggregates = aggregate(neighbours_of_nodes(matrix, n_entries), bodies_of_level, 1);
  std::copy(aggregates.of_nodes.begin(), aggregates.of_nodes.end(), of_nodes);
  bodies_of_level = std::move(aggregates.bodies);
  return static_cast<int>(bodies_of_level.size());
}
}

std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> algebraic_multigrid(
    const Epetra_RowMatrix& matrix, const int unknowns_per_node, std::vector<double> rigid_motions,
    std::vector<unsigned int> bodies) {
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
  options.elliptic = true;
  options.smoother_sweeps = 2;
  options.aggregation_threshold = 0.;
  Teuchos::ParameterList list;
  std::unique_ptr<Epetra_MultiVector> unused;
  options.set_parameters(list, unused, matrix);
  list.set("PDE equations", unknowns_per_node);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", unknowns_per_node);
  list.set("null space: vectors", rigid_motions.data());
  list.set("null space: add default vectors", false);
  bodies_of_level = std::move(bodies);
  ML_SetUserLabel(label_of_aggregation);
  ML_SetUserPartitions(aggregate_within_bodies);
  list.set("aggregation: type", "user");
  list.set("increasing or decreasing", "decreasing");  // so ML takes a node for all its unknowns
  auto result = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

}  // namespace geneva::fem
