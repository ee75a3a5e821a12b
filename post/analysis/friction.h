#pragma once

#include <optional>

#include "fem/solution.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// Friction of a contact pair, SI units.
struct FrictionFigures {
  double coefficient;    ///< mu
  double force;          ///< resultant on the source [N], of the modelled part
  double dissipated;     ///< over the load steps [J], of the modelled part, >= 0
  std::size_t sticking;  ///< nodes
  std::size_t slipping;
  std::optional<double> speed;  ///< with which all of it slides, of a mechanism [m/s], > 0
};

/// @return nothing of a pair without friction
template <int dim>
std::optional<FrictionFigures> friction_figures(const fem::Solution<dim>& solution,
                                                const fem::ContactResult<dim>& contact,
                                                const std::optional<MechanismReport>& mechanism);

}  // namespace geneva::post
