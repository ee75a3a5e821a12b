#include "fem/linear/multigrid/prolongation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/linear/multigrid/aggregation.h"
#include "fem/linear/multigrid/block_rows.h"
#include "fem/linear/multigrid/coarse_nodes.h"

namespace geneva::fem {

namespace {

/// Nodes farther apart than this many times the distance to their nearest neighbours are coupled
/// weakly: those on the long sides of cells that are longer than this. A neighbour across a corner
/// of cells of twice the size is 2.8 times as far.
constexpr double short_sides = 5.;
/// In long cells two thirds of a motion's stiffness that is the same in all layers are within the
/// layer of a node, the rest is between this and the next ones (the mass matrix of linear elements
/// along the long side: 1/6, 4/6, 1/6); and so is the largest eigenvalue without the latter.
constexpr double share_of_layer = 2. / 3.;

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

/// Steps of Jacobi's method, at the unknowns of own nodes.
template <int dim>
std::vector<Eigen::Matrix<double, dim, 1>> jacobi_steps(const Lists& near,
                                                        const CoupledNodes<dim>& nodes,
                                                        const std::vector<double>& diagonal,
                                                        const double largest_eigenvalue) {
  using Steps = Eigen::Matrix<double, dim, 1>;
  std::vector<Steps> result;
  result.reserve(nodes.n_own());
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    const double share = is_in_layer(node, near[node], nodes) ? share_of_layer : 1.;
    result.push_back(aggregation_damping / (largest_eigenvalue * share) *
                     Eigen::Map<const Steps>(&diagonal[dim * node]).cwiseInverse());
  }
  return result;
}

/// A node of each aggregate next to a node along short sides, the node itself first.
/// @param near of the node
template <int dim>
std::vector<std::size_t> representatives(const std::size_t node,
                                         const std::vector<std::size_t>& near,
                                         const CoarseNodes<dim>& coarse) {
  std::vector<std::size_t> result{node};
  for (const std::size_t other : near) {
    const int number = coarse.of_nodes[other];
    if (number != no_aggregate && std::none_of(result.begin(), result.end(), [&](const auto place) {
          return coarse.of_nodes[place] == number;
        }))
      result.push_back(other);
  }
  return result;
}

/// Rows that are zero yet, for the aggregates next to each node.
template <int dim>
std::vector<NodeRow<dim>> zero_rows(const Lists& near, const CoarseNodes<dim>& coarse) {
  std::vector<NodeRow<dim>> rows(near.size());
  for (std::size_t node = 0; node < rows.size(); ++node)
    if (coarse.of_nodes[node] != no_aggregate)
      for (const std::size_t other : representatives(node, near[node], coarse))
        rows[node].at(coarse.of_nodes[other]);
  return rows;
}

/// Adds -steps A T, where T are the rigid motions of the aggregates: a step of Jacobi's method.
template <int dim>
void add_jacobi_step(std::vector<NodeRow<dim>>& rows, const CoupledNodes<dim>& nodes,
                     const CoarseNodes<dim>& coarse,
                     const std::vector<Eigen::Matrix<double, dim, 1>>& steps) {
  nodes.matrix().visit_blocks(
      [&](const std::size_t node, const std::size_t other, const auto& entries) {
        if (rows[node].size() < 2) return;
        auto* const block = rows[node].find(coarse.of_nodes[other]);
        if (block == nullptr) return;
        const auto from_centre = nodes.position(other) - coarse.centres[other];
        *block -= steps[node].asDiagonal() * (entries * rigid_displacement(from_centre));
      });
}

/// Adds to a node's own aggregate what a row lacks of the whole's rigid motions.
template <int dim>
void restore_rigid_motions(NodeRow<dim>& row, const std::size_t node,
                           const std::vector<std::size_t>& near, const CoupledNodes<dim>& nodes,
                           const CoarseNodes<dim>& coarse) {
  RigidDisplacement<dim> own = rigid_displacement(nodes.position(node) - coarse.centres[node]);
  for (const std::size_t other : representatives(node, near, coarse))
    own -= row.at(coarse.of_nodes[other]) *
           rigid_motion<dim>(coarse.centres[other] - coarse.centres[node]);
  row.at(coarse.of_nodes[node]) += own;
}

template <int dim>
std::vector<NodeRow<dim>> smoothed_rows(const Lists& near, const CoupledNodes<dim>& nodes,
                                        const CoarseNodes<dim>& coarse,
                                        const std::vector<double>& diagonal,
                                        const double largest_eigenvalue) {
  auto rows = zero_rows(near, coarse);
  add_jacobi_step(rows, nodes, coarse, jacobi_steps(near, nodes, diagonal, largest_eigenvalue));
  for (std::size_t node = 0; node < rows.size(); ++node)
    if (rows[node].size() > 0) restore_rigid_motions(rows[node], node, near[node], nodes, coarse);
  return rows;
}

/// Gives an unknown no displacement.
/// @param unknown place among this rank's
template <int dim>
void hold(std::vector<NodeRow<dim>>& rows, const std::size_t unknown) {
  for (auto& block : rows[unknown / dim].blocks())
    block.row(static_cast<Eigen::Index>(unknown % dim)).setZero();
}

template <int dim>
void hold_constrained(std::vector<NodeRow<dim>>& rows, const Dependence& dependence) {
  for (const auto& line : dependence.constraints.get_lines())
    if (dependence.unknowns.is_element(line.index))
      hold<dim>(rows, static_cast<std::size_t>(dependence.unknowns.index_within_set(line.index)));
}

/// Rows of the nodes of other ranks that this rank's unknowns follow, by their numbers.
template <int dim>
BlockRows<RigidDisplacement<dim>> rows_followed(const std::vector<NodeRow<dim>>& rows,
                                                const Elimination& elimination,
                                                const UnknownRanges& unknowns,
                                                const MPI_Comm communicator) {
  std::vector<int> nodes;
  for (const int unknown : elimination.others())
    if (nodes.empty() || nodes.back() != unknown / dim) nodes.push_back(unknown / dim);
  BlockRows<RigidDisplacement<dim>> result;
  auto received = rows_of_others(rows, nodes, unknowns, dim, communicator);
  for (std::size_t i = 0; i < nodes.size(); ++i) result[nodes[i]] = std::move(received[i]);
  return result;
}

/// Gives the constrained unknowns their values.
template <int dim>
void distribute(std::vector<NodeRow<dim>>& rows, const Elimination& elimination,
                const UnknownRanges& unknowns, const MPI_Comm communicator) {
  const OwnNodes own(unknowns, dim);
  const auto others = rows_followed<dim>(rows, elimination, unknowns, communicator);
  for (const auto& [unknown, shares] : elimination.own()) {
    hold<dim>(rows, unknown);
    NodeRow<dim>& row = rows[unknown / dim];
    for (const auto& [carrier, share] : shares) {
      const int node = carrier / dim;
      const NodeRow<dim>& followed =
          own.have(node) ? rows[static_cast<std::size_t>(node - own.first)] : others.at(node);
      for (std::size_t i = 0; i < followed.size(); ++i)
        row.at(followed.number(i)).row(static_cast<Eigen::Index>(unknown % dim)) +=
            share * followed.block(i).row(carrier % dim);
    }
  }
}

}  // namespace

template <int dim>
Prolongation<dim> prolongation(const CoupledNodes<dim>& nodes, const Dependence& dependence,
                               const std::vector<double>& diagonal, const double largest_eigenvalue,
                               const MPI_Comm communicator) {
  const Lists near = near_neighbours(nodes);
  Aggregates aggregates = aggregates_of(nodes, near);
  CoarseNodes<dim> coarse = coarse_nodes(aggregates, nodes.positions(), nodes.matrix().pattern());
  auto rows = smoothed_rows(near, nodes, coarse, diagonal, largest_eigenvalue);
  hold_constrained<dim>(rows, dependence);
  distribute<dim>(rows, dependence.elimination, nodes.matrix().unknowns(), communicator);
  return {matrix_of(rows, coarse.unknowns), std::move(aggregates.bodies),
          std::move(coarse.own_centres)};
}

template Prolongation<2> prolongation(const CoupledNodes<2>&, const Dependence&,
                                      const std::vector<double>&, double, MPI_Comm);
template Prolongation<3> prolongation(const CoupledNodes<3>&, const Dependence&,
                                      const std::vector<double>&, double, MPI_Comm);

}  // namespace geneva::fem
