#include "fem/multigrid/prolongation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/multigrid/aggregation.h"
#include "fem/multigrid/block_row.h"

namespace geneva::fem {

namespace {

/// Nodes farther apart than this many times the distance to their nearest neighbours are coupled
/// weakly: those on the long sides of cells that are longer than this. A neighbour across a corner
/// of cells of twice the size is 2.8 times as far.
constexpr double short_sides = 5.;
/// Damping of Jacobi's method over the inverse of the largest eigenvalue, as in smoothed
/// aggregation.
constexpr double damping = 4. / 3.;
/// In long cells two thirds of a motion's stiffness that is the same in all layers are within the
/// layer of a node, the rest is between this and the next ones (the mass matrix of linear elements
/// along the long side: 1/6, 4/6, 1/6); and so is the largest eigenvalue without the latter.
constexpr double share_of_layer = 2. / 3.;

using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Lists = std::vector<std::vector<std::size_t>>;

template <int dim>
std::vector<double> nearest_distances(const CoupledNodes<dim>& nodes) {
  std::vector<double> result(nodes.n_own(), 0.);
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    double nearest = std::numeric_limits<double>::max();
    for (const std::size_t other : nodes.neighbours(node))
      if (nodes.body(other) == nodes.body(node))
        nearest = std::min(nearest, nodes.position(node).distance(nodes.position(other)));
    if (nearest < std::numeric_limits<double>::max()) result[node] = nearest;
  }
  return nodes.on_all_nodes(result);
}

/// Neighbours of own nodes in their bodies, along short sides.
template <int dim>
Lists near_neighbours(const CoupledNodes<dim>& nodes) {
  const std::vector<double> nearest = nearest_distances(nodes);
  Lists result(nodes.n_own());
  for (std::size_t node = 0; node < nodes.n_own(); ++node)
    for (const std::size_t other : nodes.neighbours(node))
      if (nodes.body(other) == nodes.body(node) &&
          nodes.position(node).distance(nodes.position(other)) <=
              short_sides * std::max(nearest[node], nearest[other]))
        result[node].push_back(other);
  return result;
}

/// Aggregates of this rank's nodes.
template <int dim>
Aggregates aggregates_of(const CoupledNodes<dim>& nodes, const Lists& near) {
  std::vector<std::vector<int>> own(nodes.n_own());
  std::vector<unsigned int> bodies;
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    bodies.push_back(nodes.body(node));
    for (const std::size_t other : near[node])
      if (other < nodes.n_own()) own[node].push_back(static_cast<int>(other));
    // Coupled to nodes of other ranks alone, it may still begin an aggregate.
    if (own[node].empty() && !near[node].empty()) own[node].push_back(static_cast<int>(node));
  }
  return aggregate(own, bodies, 2);
}

/// What a node knows of the coarse node that it belongs to.
template <int dim>
struct CoarseNodes {
  std::vector<int> of_nodes;  ///< number among those of all ranks, of each own or coupled node
  std::vector<dealii::Point<dim>> centres;  ///< of each own or coupled node's aggregate
};

template <int dim>
std::vector<dealii::Point<dim>> centres_of(const Aggregates& aggregates,
                                           const CoupledNodes<dim>& nodes) {
  std::vector<dealii::Point<dim>> centres(aggregates.bodies.size());
  std::vector<double> counts(centres.size(), 0.);
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    if (aggregates.of_nodes[node] == no_aggregate) continue;
    const auto aggregate = static_cast<std::size_t>(aggregates.of_nodes[node]);
    centres[aggregate] += nodes.position(node);
    ++counts[aggregate];
  }
  for (std::size_t aggregate = 0; aggregate < centres.size(); ++aggregate)
    centres[aggregate] /= counts[aggregate];
  return centres;
}

/// This rank's share of unknowns that are numbered rank by rank.
dealii::IndexSet own_range(const std::size_t n_own, const MPI_Comm communicator) {
  return dealii::Utilities::MPI::create_ascending_partitioning(
      communicator, static_cast<dealii::types::global_dof_index>(
                        n_own))[dealii::Utilities::MPI::this_mpi_process(communicator)];
}

/// @param range of this rank's coarse unknowns
template <int dim>
CoarseNodes<dim> coarse_nodes(const Aggregates& aggregates,
                              const std::vector<dealii::Point<dim>>& centres,
                              const dealii::IndexSet& range, const CoupledNodes<dim>& nodes) {
  const double first =
      centres.empty() ? 0. : static_cast<double>(range.nth_index_in_set(0)) / n_rigid_motions<dim>;
  std::vector<double> numbers(nodes.n_own(), no_aggregate);
  std::vector<std::vector<double>> coordinates(dim, numbers);
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    const int aggregate = aggregates.of_nodes[node];
    if (aggregate == no_aggregate) continue;
    numbers[node] = first + aggregate;
    for (unsigned int axis = 0; axis < dim; ++axis)
      coordinates[axis][node] = centres[static_cast<std::size_t>(aggregate)][axis];
  }
  CoarseNodes<dim> result;
  for (const double number : nodes.on_all_nodes(numbers))
    result.of_nodes.push_back(static_cast<int>(number));
  result.centres.resize(nodes.n_all());
  for (unsigned int axis = 0; axis < dim; ++axis) {
    const std::vector<double> all = nodes.on_all_nodes(coordinates[axis]);
    for (std::size_t node = 0; node < all.size(); ++node) result.centres[node][axis] = all[node];
  }
  return result;
}

/// Adds -step D^-1 A T, where T are the rigid motions of the aggregates, to the row of a node for
/// the coarse nodes that the row has: a step of Jacobi's method.
template <int dim>
void add_jacobi_step(NodeRow<dim>& row, const std::size_t node, const CoupledNodes<dim>& nodes,
                     const CoarseNodes<dim>& coarse, const double step) {
  const auto diagonal = nodes.diagonal_block(node).diagonal();
  nodes.visit_row(node, [&](const std::size_t other, const auto& entries) {
    auto* const block = row.find(coarse.of_nodes[other]);
    if (block == nullptr) return;
    const auto from_centre = nodes.position(other) - coarse.centres[other];
    *block -= step * diagonal.asDiagonal().inverse() * (entries * rigid_displacement(from_centre));
  });
}

/// @param near of the node
template <int dim>
NodeRow<dim> smoothed_row(const std::size_t node, const std::vector<std::size_t>& near,
                          const CoupledNodes<dim>& nodes, const CoarseNodes<dim>& coarse,
                          const double step) {
  NodeRow<dim> row;
  row.at(coarse.of_nodes[node]);
  std::vector<dealii::Tensor<1, dim>> offsets(1);  // of the row's coarse nodes from the own one
  for (const std::size_t other : near) {
    const int number = coarse.of_nodes[other];
    if (number == no_aggregate || row.find(number) != nullptr) continue;
    row.at(number);
    offsets.push_back(coarse.centres[other] - coarse.centres[node]);
  }
  if (row.size() > 1) add_jacobi_step(row, node, nodes, coarse, step);
  RigidDisplacement<dim> own = rigid_displacement(nodes.position(node) - coarse.centres[node]);
  for (std::size_t i = 0; i < row.size(); ++i) own -= row.block(i) * rigid_motion(offsets[i]);
  row.at(coarse.of_nodes[node]) += own;
  return row;
}

/// Whether a node has neighbours in its body that are not near.
template <int dim>
bool is_in_layer(const std::size_t node, const std::vector<std::size_t>& near,
                 const CoupledNodes<dim>& nodes) {
  const auto& neighbours = nodes.neighbours(node);
  const auto in_body =
      std::count_if(neighbours.begin(), neighbours.end(),
                    [&](const std::size_t other) { return nodes.body(other) == nodes.body(node); });
  return static_cast<std::size_t>(in_body) > near.size();
}

template <int dim>
std::vector<NodeRow<dim>> smoothed_rows(const Lists& near, const CoupledNodes<dim>& nodes,
                                        const CoarseNodes<dim>& coarse,
                                        const double largest_eigenvalue) {
  std::vector<NodeRow<dim>> rows(nodes.n_own());
  for (std::size_t node = 0; node < nodes.n_own(); ++node)
    if (coarse.of_nodes[node] != no_aggregate)
      rows[node] = smoothed_row(
          node, near[node], nodes, coarse,
          damping /
              (largest_eigenvalue * (is_in_layer(node, near[node], nodes) ? share_of_layer : 1.)));
  return rows;
}

/// Unknowns of the coarse nodes of a row, one node after the other.
template <int dim>
std::vector<dealii::types::global_dof_index> coarse_unknowns(const NodeRow<dim>& row) {
  std::vector<dealii::types::global_dof_index> result;
  result.reserve(row.size() * n_rigid_motions<dim>);
  for (std::size_t i = 0; i < row.size(); ++i)
    for (int j = 0; j < n_rigid_motions<dim>; ++j)
      result.push_back(coarse_unknown<dim>(row.number(i), j));
  return result;
}

/// Values of one line of a row of blocks, in the order of coarse_unknowns().
template <int dim>
std::vector<double> values_of_line(const NodeRow<dim>& row, const Eigen::Index line) {
  std::vector<double> result;
  result.reserve(row.size() * n_rigid_motions<dim>);
  for (std::size_t i = 0; i < row.size(); ++i)
    result.insert(result.end(), row.block(i).row(line).begin(), row.block(i).row(line).end());
  return result;
}

/// @param range of this rank's coarse unknowns
template <int dim>
std::unique_ptr<Matrix> matrix_of(const std::vector<NodeRow<dim>>& rows,
                                  const dealii::IndexSet& unknowns, const dealii::IndexSet& range,
                                  const dealii::AffineConstraints<double>& constraints,
                                  const MPI_Comm communicator) {
  std::vector<unsigned int> lengths;
  for (const NodeRow<dim>& row : rows)
    lengths.insert(lengths.end(), dim,
                   static_cast<unsigned int>(n_rigid_motions<dim> * row.size()));
  auto result = std::make_unique<Matrix>(unknowns, range, communicator, lengths);
  const auto first = unknowns.n_elements() == 0 ? 0 : unknowns.nth_index_in_set(0);
  for (std::size_t node = 0; node < rows.size(); ++node) {
    const auto columns = coarse_unknowns(rows[node]);
    for (unsigned int component = 0; component < dim; ++component) {
      const auto unknown =
          first + static_cast<dealii::types::global_dof_index>(node) * dim + component;
      std::vector<double> values = values_of_line(rows[node], component);
      if (constraints.is_constrained(unknown)) values.assign(values.size(), 0.);
      result->set(unknown, static_cast<dealii::types::global_dof_index>(columns.size()),
                  columns.data(), values.data(), false);
    }
  }
  result->compress(dealii::VectorOperation::insert);
  return result;
}

template <int dim>
std::vector<double> motions_of(const std::vector<dealii::Point<dim>>& centres) {
  constexpr std::size_t n = n_rigid_motions<dim>;
  std::vector<double> result(n * n * centres.size());
  for (std::size_t node = 0; node < centres.size(); ++node) {
    const RigidMotion<dim> motion = rigid_motion<dim>(centres[node]);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t mode = 0; mode < n; ++mode)
        result[(mode * centres.size() + node) * n + i] =
            motion(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(mode));
  }
  return result;
}

}  // namespace

template <int dim>
Prolongation prolongation(const CoupledNodes<dim>& nodes, const dealii::IndexSet& unknowns,
                          const dealii::AffineConstraints<double>& constraints,
                          const double largest_eigenvalue, const MPI_Comm communicator) {
  const Lists near = near_neighbours(nodes);
  const Aggregates aggregates = aggregates_of(nodes, near);
  const std::vector<dealii::Point<dim>> centres = centres_of(aggregates, nodes);
  const dealii::IndexSet range = own_range(n_rigid_motions<dim> * centres.size(), communicator);
  const CoarseNodes<dim> coarse = coarse_nodes(aggregates, centres, range, nodes);
  const auto rows = smoothed_rows(near, nodes, coarse, largest_eigenvalue);
  return {matrix_of(rows, unknowns, range, constraints, communicator), aggregates.bodies,
          motions_of(centres)};
}

template Prolongation prolongation(const CoupledNodes<2>&, const dealii::IndexSet&,
                                   const dealii::AffineConstraints<double>&, double, MPI_Comm);
template Prolongation prolongation(const CoupledNodes<3>&, const dealii::IndexSet&,
                                   const dealii::AffineConstraints<double>&, double, MPI_Comm);

}  // namespace geneva::fem
