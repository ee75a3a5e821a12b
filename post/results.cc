#include "post/results.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace geneva::post {

using dealii::Point;

namespace {

Equilibrium equilibrium(const fem::Solution<2>& solution) {
  const bool axisymmetric = solution.problem.plane == fem::PlaneKind::axisymmetric;
  std::array<double, 2> force = solution.applied_force;
  double moment = solution.applied_moment;
  for (const fem::Reaction<2>& reaction : solution.reactions) {
    force[0] += reaction.force[0];
    force[1] += reaction.force[1];
    moment += reaction.moment;
  }
  double contact_force = 0.;
  for (const fem::ContactResult<2>& contact : solution.contacts)
    contact_force = std::max(contact_force, std::hypot(contact.force[0], contact.force[1]));
  if (contact_force == 0.) return {0., 0.};
  const double defect = axisymmetric ? std::abs(force[1]) : std::hypot(force[0], force[1]);
  const double arm = solution.scales.length;
  return {defect / contact_force, axisymmetric ? 0. : std::abs(moment) / (contact_force * arm)};
}

double square_difference(const fem::PlaneStress& a, const fem::PlaneStress& b) {
  return dealii::scalar_product(a.in_plane - b.in_plane, a.in_plane - b.in_plane);
}

/// Sides of the contact are told apart by the sign of the distance along the target's normal.
std::optional<FieldDifference> field_difference(const fem::Solution<2>& solution,
                                                const ClosedForm& form,
                                                const std::vector<CellStress>& cells) {
  if (!form.line) return std::nullopt;
  std::array<double, 4> sums{0., 0., 0., 0.};
  for (const CellStress& cell : cells) {
    const double b = form.half_width();
    if (std::abs(form.along(cell.centre)) >= 2. * b || form.depth(cell.centre) >= 3. * b) continue;
    const auto exact =
        mcewen_stress(form, solution.problem.plane,
                      solution.problem.bodies[cell.body].material.poissons_ratio, cell.centre);
    if (!exact) continue;
    const std::size_t side = (cell.centre - form.centre) * form.normal > 0. ? 0 : 2;
    sums[side] += cell.area * square_difference(cell.stress, *exact);
    sums[side + 1] += cell.area;
  }
  for (double& sum : sums)
    sum = dealii::Utilities::MPI::sum(sum, solution.dof_handler->get_communicator());
  const auto root_mean_square = [&](const std::size_t side) {
    return sums[side + 1] > 0. ? std::sqrt(sums[side] / sums[side + 1]) / form.peak_pressure() : 0.;
  };
  return FieldDifference{root_mean_square(0), root_mean_square(2)};
}

ContactAnalysis analyse_contact(const fem::Solution<2>& solution,
                                const fem::ContactResult<2>& contact,
                                const std::vector<CellStress>& cells) {
  ContactAnalysis analysis{
      pressure_centre(solution, contact), closed_form(solution, contact), {}, 0., {}};
  const double half_width = std::max(contact.half_width, 1e-12 * solution.scales.length);
  analysis.max_shear = peak_shear(solution, cells, analysis.centre.place, 3. * half_width);
  const Point<2> place(analysis.max_shear.place[0], analysis.max_shear.place[1]);
  analysis.max_shear_depth = std::abs((place - analysis.centre.place) * analysis.centre.normal);
  if (analysis.hertz) analysis.difference = field_difference(solution, *analysis.hertz, cells);
  return analysis;
}

}  // namespace

std::size_t leading_contact(const fem::Solution<2>& solution) {
  const auto leading = std::max_element(
      solution.contacts.begin(), solution.contacts.end(),
      [](const auto& a, const auto& b) { return a.peak_pressure < b.peak_pressure; });
  return static_cast<std::size_t>(leading - solution.contacts.begin());
}

Results analyse(const fem::Solution<2>& solution) {
  const std::vector<CellStress> cells = cell_stresses(solution);
  Results results;
  results.nodal = nodal_stress(solution);
  for (const fem::ContactResult<2>& contact : solution.contacts)
    results.contacts.push_back(analyse_contact(solution, contact, cells));
  for (unsigned int body = 0; body < solution.problem.bodies.size(); ++body)
    results.max_von_mises.push_back(peak_von_mises(solution, results.nodal, body));
  results.equilibrium = equilibrium(solution);
  return results;
}

}  // namespace geneva::post
