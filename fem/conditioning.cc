#include "fem/conditioning.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "fem/elasticity/elasticity.h"
#include "fem/linear/constraints.h"

namespace geneva::fem {

namespace {

/// The bodies with the minimum and the maximum Young's modulus.
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

template <int dim>
const Body<dim>& body_of(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh,
                         const std::string& surface) {
  return problem.bodies[*mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface)).begin()];
}

/// @param remedy what helps besides another modulus, with a comma and "or"; may be empty
/// @throws base::InputError if the ratio is greater than most
template <int dim>
void check_ratio(const Body<dim>& stiff, const Body<dim>& soft, const double most,
                 const std::string& remedy) {
  const double ratio = stiff.material.youngs_modulus / soft.material.youngs_modulus;
  if (ratio <= most) return;
  throw base::InputError(fmt::format(
      "body '{}' has {:.3g} times the Young's modulus of body '{}'; {:.0e} times is the most that "
      "can be solved: {}give '{}' {:.3g} Pa, which changes the contact's pressure by a share of "
      "{:.0e}",
      stiff.name, ratio, soft.name, most, remedy, stiff.name, most * soft.material.youngs_modulus,
      0.5 / most));
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
double maximum_prescribed(const Problem<dim>& problem) {
  double maximum = 0.;
  for (const Support<dim>& support : problem.supports)
    for (const auto& component : support.displacement)
      maximum = std::max(maximum, std::abs(component.value_or(0.)));
  return maximum;
}

}  // namespace

template <int dim>
bool is_factorised(const Problem<dim>& problem) {
  // The multigrid takes 35 iterations there, with nu = 0.3 18, with 0.49 70, with 0.4999 500; for
  // other materials it is as fast as the factors (6000 unknowns) or faster (twice, 90 000).
  constexpr double nearly_incompressible = 10.;
  if (dim == 3) return false;
  return stiffness_ratio(problem) >= very_stiff ||
         std::any_of(problem.bodies.begin(), problem.bodies.end(), [&](const Body<dim>& body) {
           const Lame constants = lame(body.material, problem.plane);
           return constants.lambda_plane > nearly_incompressible * constants.mu;
         });
}

/// The pressure grows by the root of 1/((1 - nu1^2)/E1 + (1 - nu2^2)/E2), which a stiff body
/// changes by half of the ratio of the moduli.
template <int dim>
void check_stiffness_ratio(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  // Balance of the forces on the finest mesh of a run at the default accuracy: in the plane 3e-6
  // for 1e8, 7e-5 for 1e9 and the peak pressure 0.3 % off for 1e10; in 3-D 8e-8 for 1e6.
  constexpr double most = dim == 2 ? 1e8 : 1e6;
  // With stiff sources 1e3 takes twelve steps of 15 iterations, 1e5 does not converge in 1000
  // iterations on 10 000 unknowns; exchanged, it takes 17.
  constexpr double most_of_source = 1e3;
  const auto [soft, stiff] = extremes(problem);
  check_ratio(*stiff, *soft, most, "");
  if (dim == 3)
    for (const ContactPair& pair : problem.pairs)
      check_ratio(
          body_of(problem, mesh, pair.source), body_of(problem, mesh, pair.target), most_of_source,
          fmt::format("make '{}' the source, with a surface of its own if it is in two pairs, or ",
                      pair.target));
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
                          maximum_prescribed(scaled_problem);
  if (approach == 0. || approach >= least) return;
  throw base::InputError(
      fmt::format("the load of {:.3g} N pushes the bodies into each other by about {:.1g} m, less "
                  "than the roundings of their coordinates show ({:.1g} m): take a greater load, "
                  "or smaller bodies",
                  force * scales.force(), approach * scales.length, least * scales.length));
}

template bool is_factorised(const Problem<2>&);
template bool is_factorised(const Problem<3>&);
template void check_stiffness_ratio(const Problem<2>&, const mesh::MeshData<2>&);
template void check_stiffness_ratio(const Problem<3>&, const mesh::MeshData<3>&);
template void check_approach(const Level<2>&, const Problem<2>&, const Scales&, MPI_Comm);
template void check_approach(const Level<3>&, const Problem<3>&, const Scales&, MPI_Comm);

}  // namespace geneva::fem
