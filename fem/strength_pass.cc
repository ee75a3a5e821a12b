#include "fem/strength_pass.h"

#include <algorithm>
#include <cmath>

#include "fem/strength.h"

namespace geneva::fem {

namespace {

/// Share of the maximum by which a stress may vary over a cell of a mesh where the maximum has the
/// relative error `accuracy`, about: at Kirsch's hole the error is 0.12 to 0.18 times the square.
double first_share(const double accuracy) { return 2. * std::sqrt(accuracy); }

/// Adds what the mesh before had less: the cells around have changed the stress by so much.
template <int dim>
void add_change(StressMaximum<dim>& maximum, const double before) {
  constexpr double share_left = 1. / 3.;
  if (maximum.value == 0. || before == 0.) return;
  maximum.error += share_left * std::abs(before / maximum.value - 1.);
}

}  // namespace

template <int dim>
StrengthPass<dim>::StrengthPass(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                const std::optional<double> accuracy)
    : accuracy_(accuracy),
      singular_(
          singular_places(mesh, boundary_tractions(mesh, problem, scales_of(problem, mesh), {}))),
      share_of_maximum_(first_share(accuracy.value_or(1.))) {}

template <int dim>
std::vector<BodyStrength<dim>> StrengthPass<dim>::find(const Solution<dim>& solution,
                                                       const std::vector<double>& before) {
  stress_.emplace(recovered_stress(
      *solution.dof_handler, solution.displacement, solution.problem,
      boundary_tractions(solution.mesh, solution.problem, solution.scales, solution.contacts)));
  std::vector<BodyStrength<dim>> found = strength(solution, *stress_, singular_);
  if (before.size() == 2 * found.size())
    for (std::size_t i = 0; i < found.size(); ++i) {
      add_change(found[i].von_mises, before[2 * i]);
      add_change(found[i].tensile, before[2 * i + 1]);
    }
  return found;
}

template <int dim>
bool StrengthPass<dim>::is_open(const BodyStrength<dim>& body) const {
  return accuracy_ && std::max(body.von_mises.error, body.tensile.error) > *accuracy_;
}

template <int dim>
bool StrengthPass<dim>::is_open(const std::vector<BodyStrength<dim>>& strength) const {
  return std::any_of(strength.begin(), strength.end(),
                     [&](const BodyStrength<dim>& body) { return is_open(body); });
}

template <int dim>
unsigned int StrengthPass<dim>::flag(const Solution<dim>& solution) {
  constexpr double finer = 0.7071;
  constexpr double minimum_share = 1e-3;
  if (!stress_ || !is_open(solution.strength)) return 0;
  std::vector<bool> of_body;
  for (const BodyStrength<dim>& body : solution.strength) of_body.push_back(is_open(body));
  while (share_of_maximum_ > minimum_share) {
    if (const unsigned int flagged = flag_for_strength(solution, *stress_, solution.strength,
                                                       singular_, of_body, share_of_maximum_))
      return flagged;
    share_of_maximum_ *= finer;
  }
  return 0;
}

template <int dim>
std::vector<double> values_of(const std::vector<BodyStrength<dim>>& strength) {
  std::vector<double> values;
  for (const BodyStrength<dim>& body : strength) {
    values.push_back(body.von_mises.value);
    values.push_back(body.tensile.value);
  }
  return values;
}

template class StrengthPass<2>;
template class StrengthPass<3>;
template std::vector<double> values_of(const std::vector<BodyStrength<2>>&);
template std::vector<double> values_of(const std::vector<BodyStrength<3>>&);

}  // namespace geneva::fem
