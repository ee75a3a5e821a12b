#include "post/analysis/friction.h"

#include <algorithm>
#include <cmath>

namespace geneva::post {

template <int dim>
std::optional<FrictionFigures> friction_figures(const fem::Solution<dim>& solution,
                                                const fem::ContactResult<dim>& contact,
                                                const std::optional<MechanismReport>& mechanism) {
  const auto& pairs = solution.problem.pairs;
  const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const fem::ContactPair& one) {
    return one.source == contact.source && one.target == contact.target;
  });
  if (pair == pairs.end() || pair->friction.coefficient == 0.) return std::nullopt;
  const auto count = [&](const fem::NodeStatus status) {
    return static_cast<std::size_t>(
        std::count_if(contact.nodes.begin(), contact.nodes.end(),
                      [&](const auto& node) { return node.status == status; }));
  };
  FrictionFigures figures{
      pair->friction.coefficient,    fem::magnitude(contact.friction_force), 0.,
      count(fem::NodeStatus::stick), count(fem::NodeStatus::slip),           std::nullopt};
  if (!solution.instants.empty())
    figures.dissipated =
        solution.instants.back().pairs[static_cast<std::size_t>(pair - pairs.begin())].dissipated;
  if (mechanism && pair->friction.slides()) figures.speed = std::abs(mechanism->load.slip_speed);
  return figures;
}

template std::optional<FrictionFigures> friction_figures(const fem::Solution<2>&,
                                                         const fem::ContactResult<2>&,
                                                         const std::optional<MechanismReport>&);
template std::optional<FrictionFigures> friction_figures(const fem::Solution<3>&,
                                                         const fem::ContactResult<3>&,
                                                         const std::optional<MechanismReport>&);

}  // namespace geneva::post
