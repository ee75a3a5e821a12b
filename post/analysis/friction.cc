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
  FrictionFigures figures{pair->friction.coefficient, fem::magnitude(contact.friction_force),
                          std::nullopt};
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
