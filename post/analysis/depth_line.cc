#include "post/analysis/depth_line.h"

#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <array>

#include "fem/discretisation/gather.h"
#include "post/analysis/surface_body.h"

namespace geneva::post {

using dealii::Point;
using dealii::Tensor;

namespace {

constexpr unsigned int n_steps = 96;
constexpr double half_widths_deep = 4.;

ContactStress in_contact_frame(const fem::PlaneStress& stress, const Tensor<1, 2>& normal) {
  const Tensor<1, 2> along({-normal[1], normal[0]});
  return {along * (stress.in_plane * along), normal * (stress.in_plane * normal),
          stress.out_of_plane, in_plane_shear(stress)};
}

/// Index of a place, how far it is outside of the cell that gave the stress (in units of the cell),
/// and the stress components: one array, since it travels between ranks.
using Found = std::array<double, 2 + n_stress_components<2>>;

/// Stresses at those places [units of the mesh] that lie in cells of this rank.
std::vector<Found> evaluate(const NodalStress<2>& stress, const unsigned int body,
                            const std::vector<Point<2>>& places) {
  constexpr double tolerance = 1e-2;  // the contact's undeformed sides lie a gap apart
  std::vector<Found> result;
  const dealii::MappingQ1<2> mapping;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    dealii::BoundingBox<2> box = cell->bounding_box();
    box.extend(tolerance * cell->diameter());
    for (unsigned int place = 0; place < places.size(); ++place) {
      if (!box.point_inside(places[place])) continue;
      const Point<2> at = mapping.transform_real_to_unit_cell(cell, places[place]);
      const double outside = dealii::GeometryInfo<2>::distance_to_unit_cell(at);
      if (outside > tolerance) continue;
      const Point<2> inside = dealii::GeometryInfo<2>::project_to_unit_cell(at);
      Found found{static_cast<double>(place), outside};
      for (const unsigned int vertex : cell->vertex_indices()) {
        const double weight = dealii::GeometryInfo<2>::d_linear_shape_function(inside, vertex);
        for (unsigned int c = 0; c < n_stress_components<2>; ++c)
          found[2 + c] += weight * stress.values(cell->vertex_dof_index(vertex, c));
      }
      result.push_back(found);
    }
  }
  return result;
}

}  // namespace

std::vector<DepthSample> depth_line(const fem::Solution<2>& solution,
                                    const fem::ContactResult<2>& contact,
                                    const PressureCentre& centre,
                                    const std::optional<ClosedForm>& hertz,
                                    const NodalStress<2>& stress) {
  const double step = half_widths_deep * contact.half_width / n_steps;
  std::vector<Point<2>> places;
  for (unsigned int i = 0; i <= n_steps; ++i)
    places.push_back((centre.place - i * step * centre.normal) / solution.scales.length);
  const unsigned int body = body_of(solution, contact.target);
  std::vector<const Found*> nearest(places.size(), nullptr);
  const std::vector<Found> all =
      fem::gathered(solution.dof_handler->get_communicator(), evaluate(stress, body, places));
  for (const Found& found : all) {
    const Found*& best = nearest[static_cast<std::size_t>(found[0])];
    if (best == nullptr || found[1] < (*best)[1]) best = &found;
  }

  const double poissons_ratio = solution.problem.bodies[body].material.poissons_ratio;
  std::vector<DepthSample> samples;
  for (unsigned int i = 0; i < places.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const auto at_place = assembled_stress<2>(
        [&](const unsigned int component) { return (*nearest[i])[2 + component]; });
    samples.push_back({i * step, in_contact_frame(at_place, centre.normal), std::nullopt});
    if (!hertz) continue;
    const auto exact = mcewen_stress(*hertz, solution.problem.plane, poissons_ratio,
                                     solution.scales.length * places[i]);
    if (exact) samples.back().closed_form = in_contact_frame(*exact, centre.normal);
  }
  return samples;
}

}  // namespace geneva::post
