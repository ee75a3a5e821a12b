#include "fem/linear/multigrid/coarse_nodes.h"

#include "fem/linear/multigrid/rigid_displacement.h"

namespace geneva::fem {

namespace {

template <int dim>
std::vector<dealii::Point<dim>> centres_of(const Aggregates& aggregates,
                                           const std::vector<dealii::Point<dim>>& positions) {
  std::vector<dealii::Point<dim>> centres(aggregates.bodies.size());
  std::vector<double> counts(centres.size(), 0.);
  for (std::size_t node = 0; node < aggregates.of_nodes.size(); ++node) {
    if (aggregates.of_nodes[node] == no_aggregate) continue;
    const auto aggregate = static_cast<std::size_t>(aggregates.of_nodes[node]);
    centres[aggregate] += positions[node];
    ++counts[aggregate];
  }
  for (std::size_t aggregate = 0; aggregate < centres.size(); ++aggregate)
    centres[aggregate] /= counts[aggregate];
  return centres;
}

}  // namespace

template <int dim>
std::vector<dealii::Point<dim>> on_all_nodes(const std::vector<dealii::Point<dim>>& of_own_nodes,
                                             const NodePattern& pattern) {
  std::vector<dealii::Point<dim>> result(pattern.n_places());
  std::vector<double> coordinates(of_own_nodes.size());
  for (unsigned int axis = 0; axis < dim; ++axis) {
    for (std::size_t node = 0; node < coordinates.size(); ++node)
      coordinates[node] = of_own_nodes[node][axis];
    const std::vector<double> all = pattern.on_all_nodes(coordinates);
    for (std::size_t node = 0; node < all.size(); ++node) result[node][axis] = all[node];
  }
  return result;
}

template <int dim>
CoarseNodes<dim> coarse_nodes(const Aggregates& aggregates,
                              const std::vector<dealii::Point<dim>>& positions,
                              const NodePattern& pattern) {
  constexpr int n = n_rigid_motions<dim>;
  std::vector<dealii::Point<dim>> own_centres = centres_of(aggregates, positions);
  UnknownRanges unknowns(n * static_cast<int>(own_centres.size()),
                         pattern.unknowns().communicator());
  const OwnNodes own(unknowns, n);
  std::vector<double> numbers;
  std::vector<dealii::Point<dim>> centres;
  for (const int aggregate : aggregates.of_nodes) {
    const bool has_one = aggregate != no_aggregate;
    numbers.push_back(has_one ? own.first + aggregate : no_aggregate);
    centres.push_back(has_one ? own_centres[static_cast<std::size_t>(aggregate)]
                              : dealii::Point<dim>());
  }
  std::vector<int> of_nodes;
  for (const double number : pattern.on_all_nodes(numbers))
    of_nodes.push_back(static_cast<int>(number));
  return {std::move(of_nodes), on_all_nodes(centres, pattern), std::move(own_centres),
          std::move(unknowns)};
}

template std::vector<dealii::Point<2>> on_all_nodes(const std::vector<dealii::Point<2>>&,
                                                    const NodePattern&);
template std::vector<dealii::Point<3>> on_all_nodes(const std::vector<dealii::Point<3>>&,
                                                    const NodePattern&);
template CoarseNodes<2> coarse_nodes(const Aggregates&, const std::vector<dealii::Point<2>>&,
                                     const NodePattern&);
template CoarseNodes<3> coarse_nodes(const Aggregates&, const std::vector<dealii::Point<3>>&,
                                     const NodePattern&);

}  // namespace geneva::fem
