#include "fem/strength_pass.h"

#include <algorithm>
#include <cmath>

#include "fem/strength.h"
#include "fem/strength_refinement.h"
#include "fem/stress_error.h"

namespace geneva::fem {

template <int dim>
StrengthPass<dim>::StrengthPass(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                const std::optional<double> accuracy)
    : has_contact_(has_contact(problem)),
      accuracy_(accuracy),
      mesh_(mesh),
      by_geometry_(
          singular_places(mesh, boundary_tractions(mesh, problem, scales_of(problem, mesh), {}))) {}

namespace {

/// Share of the maximum by which a stress may vary over a cell of a mesh where the maximum has the
/// relative error `accuracy`, about: at Kirsch's hole the error is 0.12 to 0.18 times the square.
double first_share(const double accuracy) { return 2. * std::sqrt(accuracy); }

/// Beside a contact in the plane: adds what the mesh before had less, since the cells around have
/// changed the stress by so much.
template <int dim>
void add_change(StressMaximum<dim>& maximum, const double before) {
  constexpr double share_left = 1. / 3.;
  if (before > 0.) maximum.error += share_left * std::abs(before / maximum.value - 1.);
}

/// Without contact and in 3-D counts all that the cells leave open: how much of it cancels does not
/// show in what earlier meshes have closed, since near cells are finer first.
/// @param before value on the mesh before; 0: there was none
template <int dim>
void add_error(StressMaximum<dim>& maximum, const bool has_contact, const double before) {
  if (maximum.value == 0.) return;
  if (dim == 3 || !has_contact)
    maximum.error += maximum.open;
  else
    add_change(maximum, before);
  if (std::isnan(maximum.error)) maximum.error = 1.;  // nothing is known then
}

}  // namespace

template <int dim>
std::vector<BodyStrength<dim>> StrengthPass<dim>::find(const Solution<dim>& solution,
                                                       const std::vector<LevelRecord>& before) {
  stress_.emplace(recovered_stress(*solution.dof_handler, solution.displacement, solution.problem,
                                   boundary_tractions(solution)));
  singular_ = by_geometry_;
  for (const SingularPlace<dim>& place : grown_places(mesh_, before)) singular_.push_back(place);
  std::vector<BodyStrength<dim>> found = strength(solution, *stress_, singular_);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const StrengthRecord last = before.empty() ? StrengthRecord{} : before.back().strength[i];
    add_error(found[i].von_mises, has_contact_, last.von_mises.value);
    add_error(found[i].tensile, has_contact_, last.tensile.value);
  }
  return found;
}

template <int dim>
std::vector<const StressMaximum<dim>*> StrengthPass<dim>::wanted(
    const BodyStrength<dim>& body) const {
  std::vector<const StressMaximum<dim>*> result;
  if (!accuracy_) return result;
  const auto is_worth_refining = [&](const StressMaximum<dim>& maximum) {
    if (maximum.is_minor || maximum.is_beside_contact() ||
        (has_contact_ && !is_clear(singular_, maximum.place)))
      return false;
    return maximum.may_be_hidden || maximum.error > std::max(*accuracy_, maximum.choice);
  };
  for (const StressMaximum<dim>* const maximum : {&body.von_mises, &body.tensile})
    if (is_worth_refining(*maximum)) result.push_back(maximum);
  if (!has_contact_ && !result.empty()) return {&body.von_mises, &body.tensile};
  return result;
}

template <int dim>
unsigned int StrengthPass<dim>::flag(const Solution<dim>& solution, const MeshFor next) const {
  if (!stress_) return 0;
  WantedMaxima<dim> of_bodies;
  for (const BodyStrength<dim>& body : solution.strength) of_bodies.push_back(wanted(body));
  if (std::all_of(of_bodies.begin(), of_bodies.end(),
                  [](const auto& maxima) { return maxima.empty(); }))
    return 0;
  if (!has_contact_)
    return flag_open<dim>(solution, *stress_, OutsideOfContact<dim>(solution, singular_), of_bodies,
                          [](const StressCell<dim>&) { return true; });
  if constexpr (dim == 3) {
    return flag_in_space(solution, *stress_, singular_, of_bodies, *accuracy_, next);
  } else {
    constexpr double finer = 0.7071;
    constexpr double minimum_share = 1e-3;
    unsigned int flagged = 0;
    double share = first_share(*accuracy_);
    while (flagged == 0 && share > minimum_share) {
      flagged = flag_in_plane(solution, *stress_, singular_, of_bodies, share, *accuracy_);
      share *= finer;
    }
    return flagged;
  }
}

template <int dim>
bool is_stressed(const std::vector<BodyStrength<dim>>& strength) {
  return std::any_of(strength.begin(), strength.end(),
                     [](const auto& body) { return body.von_mises.value > 0.; });
}

template <int dim>
double maximum_error(const std::vector<BodyStrength<dim>>& strength) {
  double error = 0.;
  for (const BodyStrength<dim>& body : strength)
    error = std::max({error, body.von_mises.error, body.tensile.error});
  return std::min(error, 1.);
}

namespace {

template <int dim>
StressRecord record_of(const StressMaximum<dim>& maximum) {
  StressRecord record{maximum.value, {}, maximum.is_round};
  for (unsigned int i = 0; i < dim; ++i) record.place[i] = maximum.place[i];
  return record;
}

}  // namespace

template <int dim>
std::vector<StrengthRecord> record_of(const std::vector<BodyStrength<dim>>& strength) {
  std::vector<StrengthRecord> records;
  for (const BodyStrength<dim>& body : strength)
    records.push_back({record_of(body.von_mises), record_of(body.tensile)});
  return records;
}

template class StrengthPass<2>;
template class StrengthPass<3>;
template bool is_stressed(const std::vector<BodyStrength<2>>&);
template bool is_stressed(const std::vector<BodyStrength<3>>&);
template double maximum_error(const std::vector<BodyStrength<2>>&);
template double maximum_error(const std::vector<BodyStrength<3>>&);
template std::vector<StrengthRecord> record_of(const std::vector<BodyStrength<2>>&);
template std::vector<StrengthRecord> record_of(const std::vector<BodyStrength<3>>&);

}  // namespace geneva::fem
