#include "post/analysis/friction.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geneva::post {

namespace {

/// That a contact is of; none only of a contact that is not the solution's.
template <int dim>
std::vector<fem::ContactPair>::const_iterator problem_pair(const fem::Solution<dim>& solution,
                                                           const fem::ContactResult<dim>& contact) {
  const auto& pairs = solution.problem.pairs;
  return std::find_if(pairs.begin(), pairs.end(), [&](const fem::ContactPair& one) {
    return one.source == contact.source && one.target == contact.target;
  });
}

/// Of the area in contact.
template <int dim>
double sticking_share(const fem::ContactResult<dim>& contact) {
  double closed = 0.;
  double sticking = 0.;
  for (const fem::ContactNode<dim>& node : contact.nodes) {
    if (fem::is_closed(node.status)) closed += node.tributary;
    if (node.status == fem::NodeStatus::stick) sticking += node.tributary;
  }
  return closed > 0. ? sticking / closed : 0.;
}

}  // namespace

template <int dim>
double sliding_friction(const fem::Solution<dim>& solution, const fem::ContactResult<dim>& contact,
                        const dealii::Tensor<1, dim>& direction) {
  constexpr double rounding = 1e-9;
  const auto pair = problem_pair(solution, contact);
  if (pair == solution.problem.pairs.end()) return 0.;
  double along = 0.;
  for (unsigned int i = 0; i < dim; ++i) along += pair->friction.sliding[i] * direction[i];
  return std::abs(along) < rounding ? 0. : std::copysign(pair->friction.coefficient, along);
}

template <int dim>
std::optional<FrictionFigures> friction_figures(const fem::Solution<dim>& solution,
                                                const fem::ContactResult<dim>& contact,
                                                const std::optional<MechanismReport>& mechanism) {
  const auto& pairs = solution.problem.pairs;
  const auto pair = problem_pair(solution, contact);
  if (pair == pairs.end() || pair->friction.coefficient == 0.) return std::nullopt;
  const auto count = [&](const fem::NodeStatus status) {
    return static_cast<std::size_t>(
        std::count_if(contact.nodes.begin(), contact.nodes.end(),
                      [&](const auto& node) { return node.status == status; }));
  };
  FrictionFigures figures{pair->friction.coefficient,
                          fem::magnitude(contact.friction_force),
                          0.,
                          count(fem::NodeStatus::stick),
                          count(fem::NodeStatus::slip),
                          std::nullopt,
                          std::nullopt};
  if (!pair->friction.slides()) figures.sticking_share = sticking_share(contact);
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

template double sliding_friction(const fem::Solution<2>&, const fem::ContactResult<2>&,
                                 const dealii::Tensor<1, 2>&);
template double sliding_friction(const fem::Solution<3>&, const fem::ContactResult<3>&,
                                 const dealii::Tensor<1, 3>&);

}  // namespace geneva::post
