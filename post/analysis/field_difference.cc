#include "post/analysis/field_difference.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <cmath>
#include <vector>

namespace geneva::post {

using dealii::Point;

std::optional<FieldDifference> field_difference(const fem::Solution<2>& solution,
                                                const ClosedForm& form,
                                                const fem::NodalStress<2>& stress) {
  if (!form.line) return std::nullopt;
  const double b = form.half_width();
  const double length = solution.scales.length;
  const dealii::QGauss<2> points(2);
  dealii::FEValues<2> values(
      *stress.element, points,
      dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
  std::vector<dealii::Vector<double>> at_points(
      points.size(), dealii::Vector<double>(fem::n_stress_components<2>));
  std::array<double, 4> sums{};  // square of the difference and area, of source and target
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    const Point<2> centre(length * cell->center());
    const double reach = length * cell->diameter();
    if (!cell->is_locally_owned() || centre.distance(form.centre) > 4. * b + reach) continue;
    const double poissons_ratio =
        solution.problem.bodies[cell->material_id()].material.poissons_ratio;
    const std::size_t side = (centre - form.centre) * form.normal > 0. ? 0 : 2;
    values.reinit(cell);
    values.get_function_values(stress.values, at_points);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Point<2> place(length * values.quadrature_point(q));
      if (std::abs(form.along(place)) >= 2. * b || form.depth(place) >= 3. * b) continue;
      const auto exact = mcewen_stress(form, solution.problem.plane, poissons_ratio, place);
      if (!exact) continue;
      const auto computed =
          fem::assembled_stress<2>([&](const unsigned int i) { return at_points[q](i); });
      const auto difference = computed.in_plane - exact->in_plane;
      sums[side] += values.JxW(q) * dealii::scalar_product(difference, difference);
      sums[side + 1] += values.JxW(q);
    }
  }
  for (double& sum : sums)
    sum = dealii::Utilities::MPI::sum(sum, solution.dof_handler->get_communicator());
  const auto root_mean_square = [&](const std::size_t side) {
    return sums[side + 1] > 0. ? std::sqrt(sums[side] / sums[side + 1]) / form.peak_pressure() : 0.;
  };
  return FieldDifference{root_mean_square(0), root_mean_square(2)};
}

}  // namespace geneva::post
