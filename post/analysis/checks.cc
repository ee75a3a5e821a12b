#include "post/analysis/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace geneva::post {

namespace {

/// Limits of what rounding, the linear solver and the active set leave behind.
constexpr double balance_limit = 1e-6;
constexpr double energy_limit = 1e-8;
constexpr double complementarity_limit = 1e-6;
constexpr double penetration_limit = 1e-3;
/// Chords in the mesh for the drawn wheel's arcs make 1.3e-4 (johnson-optimum-wheel).
constexpr double torque_limit = 5e-3;

/// How far the bodies approach each other, b p0/E: what a gap is measured with [m].
template <int dim>
double approach(const fem::Solution<dim>& solution, const fem::ContactResult<dim>& contact,
                const double half_width) {
  double modulus = std::numeric_limits<double>::max();
  for (const fem::Body<dim>& body : solution.problem.bodies)
    modulus = std::min(modulus, body.material.youngs_modulus);
  return half_width * contact.peak_pressure / modulus;
}

/// Maximum of p |g|/(p0 approach) and -p/p0: 0 where no pressure pulls and none acts across a gap.
template <int dim>
double complementarity_residual(const fem::ContactResult<dim>& contact, const double approach) {
  double residual = 0.;
  for (const fem::ContactNode<dim>& node : contact.nodes) {
    const double pressure = node.pressure / contact.peak_pressure;
    residual = std::max({residual, std::abs(pressure * node.gap) / approach, -pressure});
  }
  return residual;
}

template <int dim>
double energy_residual(const fem::Solution<dim>& solution) {
  double residual = 0.;
  for (const fem::Instant<dim>& instant : solution.instants)
    residual = std::max(residual, instant.energy.imbalance());
  return residual;
}

/// Of all contacts together.
template <int dim>
std::vector<Check> contact_checks(const fem::Solution<dim>& solution, const Results<dim>& results) {
  double complementarity = 0.;
  double penetration = 0.;
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    const fem::ContactResult<dim>& contact = solution.contacts[i];
    const double scale = approach(solution, contact, half_width(contact, results.contacts[i]));
    if (scale <= 0.) continue;  // one node at most is in contact
    complementarity = std::max(complementarity, complementarity_residual(contact, scale));
    penetration = std::max(penetration, contact.max_penetration / scale);
  }
  return {{"complementarity",
           "maximum pressure times gap, and maximum tension, over peak pressure times approach",
           complementarity, complementarity_limit},
          {"penetration", "maximum overlap left open over the approach", penetration,
           penetration_limit}};
}

/// Over the moment of the pin, of which the wheel's own inertia may leave little.
double torque_difference(const MechanismReport& mechanism) {
  const double expected = mechanism.expected_bore_torque;
  return std::abs(*mechanism.bore_torque - expected) /
         std::max(std::abs(expected), std::abs(mechanism.load.moment));
}

}  // namespace

template <int dim>
std::vector<Check> checks(const fem::Solution<dim>& solution, const Results<dim>& results,
                          const RunReport& report) {
  const bool has_contact = fem::has_contact(solution.problem);
  const std::string scale =
      has_contact ? "contact force" : "maximum stress on the square of the model's extent";
  std::vector<Check> list{
      {"balance of forces", "sum of all loads and reactions over the " + scale,
       results.equilibrium.force_residual, balance_limit},
      {"balance of moments", "sum of all moments over the " + scale + ", times that extent",
       results.equilibrium.moment_residual, balance_limit}};
  if (!solution.problem.steps.empty())
    list.push_back(
        {"balance of energy",
         "work of loads and supports, less what is stored and what contacts take, over the "
         "greatest of them, maximum of the load steps",
         energy_residual(solution),
         // what is out of balance does work, too: by its share of the forces
         energy_limit + results.equilibrium.force_residual});
  if (report.mechanism && report.mechanism->bore_torque)
    list.push_back({report.mechanism->held_surface + " torque",
                    "its reaction against what the load asks for, over the greater of this and the "
                    "pin's moment",
                    torque_difference(*report.mechanism), torque_limit});
  if (has_contact)
    for (Check& check : contact_checks(solution, results)) list.push_back(std::move(check));
  list.push_back({"convergence",
                  fmt::format("estimated relative error of the {}, and what was asked for",
                              has_contact ? "pressure" : "maximum stress"),
                  solution.error_estimate, report.accuracy});
  return list;
}

template std::vector<Check> checks(const fem::Solution<2>&, const Results<2>&, const RunReport&);
template std::vector<Check> checks(const fem::Solution<3>&, const Results<3>&, const RunReport&);

}  // namespace geneva::post
