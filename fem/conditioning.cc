#include "fem/conditioning.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fem/elasticity.h"

namespace geneva::fem {

namespace {

/// The bodies with the least and the greatest Young's modulus.
template <int dim>
std::pair<const Body<dim>*, const Body<dim>*> extremes(const Problem<dim>& problem) {
  const auto [soft, stiff] = std::minmax_element(
      problem.bodies.begin(), problem.bodies.end(), [](const auto& one, const auto& other) {
        return one.material.youngs_modulus < other.material.youngs_modulus;
      });
  return {&*soft, &*stiff};
}

template <int dim>
double stiffness_ratio(const Problem<dim>& problem) {
  const auto [soft, stiff] = extremes(problem);
  return stiff->material.youngs_modulus / soft->material.youngs_modulus;
}

/// Sum of all forces' magnitudes by component.
template <int dim>
double total_force(const Level<dim>& level, const MPI_Comm communicator) {
  double own = 0.;
  for (std::size_t cell = 0; cell < level.cells.size(); ++cell)
    own += level.cells.load(cell).l1_norm();
  double sum = dealii::Utilities::MPI::sum(own, communicator);
  for (const NodalForce& force : level.tie_forces) sum += std::abs(force.value);
  return sum;
}

template <int dim>
double greatest_prescribed(const Problem<dim>& problem) {
  double greatest = 0.;
  for (const Support<dim>& support : problem.supports)
    for (const auto& component : support.displacement)
      greatest = std::max(greatest, std::abs(component.value_or(0.)));
  return greatest;
}

}  // namespace

template <int dim>
bool is_factorised(const Problem<dim>& problem) {
  constexpr double nearly_incompressible = 10.;
  constexpr double very_stiff = 100.;
  if (dim == 3) return false;
  return stiffness_ratio(problem) >= very_stiff ||
         std::any_of(problem.bodies.begin(), problem.bodies.end(), [&](const Body<dim>& body) {
           const Lame constants = lame(body.material, problem.plane);
           return constants.lambda_plane > nearly_incompressible * constants.mu;
         });
}

template <int dim>
void check_stiffness_ratio(const Problem<dim>& problem) {
  constexpr double most = dim == 2 ? 1e8 : 1e6;
  const double ratio = stiffness_ratio(problem);
  if (ratio <= most) return;
  const auto [soft, stiff] = extremes(problem);
  throw std::invalid_argument(fmt::format(
      "body '{}' has {:.3g} times the Young's modulus of body '{}'; {:.0e} times is the most that "
      "double precision can solve: give '{}' {:.3g} Pa, which changes the contact by less than a "
      "millionth",
      stiff->name, ratio, soft->name, most, stiff->name, most * soft->material.youngs_modulus));
}

/// A line load F' brings two bodies together by about 2 F'/(pi E*) where they touch, whatever their
/// radii (K. L. Johnson, Contact Mechanics, 1985, Eq. 4.43: b^2/(2 R)), a point load F by the power
/// 2/3 of F/(E* R^2) times R (Eq. 4.23). The gap's roundings show in the pressure where that is
/// less than some fifty of those of the coordinates: with 65 it is right to 0.2 %, with 7 it is
/// noise.
template <int dim>
void check_approach(const Level<dim>& level, const Problem<dim>& scaled_problem,
                    const Scales& scales, const MPI_Comm communicator) {
  constexpr double least = 50. * std::numeric_limits<double>::epsilon();
  const bool is_line = dim == 2 && scaled_problem.plane != PlaneKind::axisymmetric;
  const double force = total_force(level, communicator);
  const double softest = extremes(scaled_problem).first->material.youngs_modulus;
  const double approach = (is_line ? force / (scaled_problem.thickness * softest)
                                   : std::pow(force / softest, 2. / 3.)) +
                          greatest_prescribed(scaled_problem);
  if (approach == 0. || approach >= least) return;
  throw std::invalid_argument(
      fmt::format("the load of {:.3g} N pushes the bodies into each other by about {:.1g} m, less "
                  "than the roundings of their coordinates show ({:.1g} m): take a greater load, "
                  "or smaller bodies",
                  force * scales.force(), approach * scales.length, least * scales.length));
}

template bool is_factorised(const Problem<2>&);
template bool is_factorised(const Problem<3>&);
template void check_stiffness_ratio(const Problem<2>&);
template void check_stiffness_ratio(const Problem<3>&);
template void check_approach(const Level<2>&, const Problem<2>&, const Scales&, MPI_Comm);
template void check_approach(const Level<3>&, const Problem<3>&, const Scales&, MPI_Comm);

}  // namespace geneva::fem
