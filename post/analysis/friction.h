#pragma once

#include <deal.II/base/tensor.h>

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
  /// Area that the sticking nodes stand for over that of all in contact: in the plane c/a, between
  /// spheres (c/a)^2; none where sliding is imposed.
  std::optional<double> sticking_share;
  std::optional<double> speed;  ///< with which all of it slides, of a mechanism [m/s], > 0
};

/// @return nothing of a pair without friction
template <int dim>
std::optional<FrictionFigures> friction_figures(const fem::Solution<dim>& solution,
                                                const fem::ContactResult<dim>& contact,
                                                const std::optional<MechanismReport>& mechanism);

/// mu of a contact that slides everywhere; > 0 where the source slides along a direction, so that
/// the target's traction points along it, < 0 where it slides against it, 0 across it or without
/// friction.
template <int dim>
double sliding_friction(const fem::Solution<dim>& solution, const fem::ContactResult<dim>& contact,
                        const dealii::Tensor<1, dim>& direction);

}  // namespace geneva::post
