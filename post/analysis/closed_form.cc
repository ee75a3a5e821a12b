#include "post/analysis/closed_form.h"

#include <algorithm>
#include <cmath>

#include "loads/contact_limits.h"
#include "post/analysis/friction.h"
#include "post/analysis/surface_body.h"

namespace geneva::post {

using dealii::Point;
using dealii::Tensor;

namespace {

bool on_axis(const fem::Solution<2>& solution, const int circle) {
  return circle < 0 || std::abs(solution.mesh.circles[static_cast<std::size_t>(circle)].centre[0]) <
                           1e-9 * solution.scales.length;
}

}  // namespace

double ClosedForm::pressure(const double arc_length) const {
  const double distance = arc_length - centre_arc_length;
  return line ? line->pressure(distance) : point->pressure(distance);
}

double ClosedForm::depth(const Point<2>& place) const {
  return std::abs((place - centre) * normal);
}

double ClosedForm::along(const Point<2>& place) const {
  return (place - centre) * Tensor<1, 2>({-normal[1], normal[0]});
}

PressureCentre pressure_centre(const fem::Solution<2>& solution,
                               const fem::ContactResult<2>& contact) {
  double force = 0.;
  PressureCentre centre{{}, 0., {}};
  Tensor<1, 2> place;
  for (const fem::ContactNode<2>& node : contact.nodes) {
    const double share = node.pressure * node.tributary;
    force += share;
    place += share * Tensor<1, 2>({node.position[0], node.position[1]});
    centre.arc_length += share * node.arc_length;
    centre.normal += share * Tensor<1, 2>({node.normal[0], node.normal[1]});
  }
  if (force <= 0.) return centre;
  centre.place = Point<2>(place / force);
  centre.arc_length /= force;
  centre.normal /= centre.normal.norm();
  const bool axisymmetric = solution.problem.plane == fem::PlaneKind::axisymmetric;
  if (!axisymmetric && !contact.symmetric) return centre;
  // The model is one half: the contact's centre is its end on the symmetry plane or axis.
  const auto end =
      std::max_element(contact.nodes.begin(), contact.nodes.end(),
                       [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
  const fem::ContactNode<2>& node =
      std::distance(contact.nodes.begin(), end) * 2 <
              std::distance(contact.nodes.begin(), contact.nodes.end())
          ? contact.nodes.front()
          : contact.nodes.back();
  return {Point<2>(node.position[0], node.position[1]), node.arc_length,
          Tensor<1, 2>({node.normal[0], node.normal[1]})};
}

std::optional<ClosedForm> closed_form(const fem::Solution<2>& solution,
                                      const fem::ContactResult<2>& contact) {
  const bool axisymmetric = solution.problem.plane == fem::PlaneKind::axisymmetric;
  const double relative_curvature =
      curvature(solution, contact.source_circle, contact.source_is_convex) +
      curvature(solution, contact.target_circle, contact.target_is_convex);
  const double resultant = fem::magnitude(contact.force);
  if (relative_curvature * solution.scales.length <= 1e-9 || resultant <= 0.) return std::nullopt;
  if (axisymmetric &&
      !(on_axis(solution, contact.source_circle) && on_axis(solution, contact.target_circle)))
    return std::nullopt;

  const loads::Elastic source = material_of(solution, contact.source);
  const loads::Elastic target = material_of(solution, contact.target);
  const PressureCentre centre = pressure_centre(solution, contact);
  ClosedForm form{};
  form.force = contact.symmetric && !axisymmetric ? 2. * resultant : resultant;
  form.relative_radius = 1. / relative_curvature;
  form.contact_modulus = solution.problem.plane == fem::PlaneKind::plane_stress
                             ? loads::contact_modulus_plane_stress(source, target)
                             : loads::contact_modulus(source, target);
  form.centre = centre.place;
  form.centre_arc_length = centre.arc_length;
  form.normal = centre.normal;
  form.friction =
      sliding_friction(solution, contact, Tensor<1, 2>({-centre.normal[1], centre.normal[0]}));
  if (axisymmetric) {
    form.point = loads::hertz_point(form.force, form.relative_radius, form.contact_modulus,
                                    std::min(source.poissons_ratio, target.poissons_ratio));
    return form;
  }
  form.line = loads::hertz_line(form.force / solution.problem.thickness, form.relative_radius,
                                form.contact_modulus);
  form.sliding_shear = loads::maximum_sliding_shear(*form.line, std::abs(form.friction));
  return form;
}

std::optional<fem::PlaneStress> mcewen_stress(const ClosedForm& form, const fem::PlaneKind plane,
                                              const double poissons_ratio, const Point<2>& place) {
  if (!form.line) return std::nullopt;
  const double b = form.line->half_width;
  const double x = form.along(place);
  const double signed_depth = (place - form.centre) * form.normal;
  const double z = std::abs(signed_depth);
  if (std::abs(x) >= 4. * b || z >= 6. * b) return std::nullopt;
  const double traction = (signed_depth < 0. ? 1. : -1.) * form.friction;
  const loads::ContactStress local = loads::sliding_stress(*form.line, traction, x, z);
  const Tensor<1, 2> tangent({-form.normal[1], form.normal[0]});
  const Tensor<1, 2> inward = (signed_depth < 0. ? -1. : 1.) * form.normal;
  fem::PlaneStress result;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = i; j < 2; ++j)
      result.in_plane[i][j] = local.xx * tangent[i] * tangent[j] +
                              local.zz * inward[i] * inward[j] +
                              local.xz * (tangent[i] * inward[j] + inward[i] * tangent[j]);
  result.out_of_plane =
      plane == fem::PlaneKind::plane_stress ? 0. : poissons_ratio * (local.xx + local.zz);
  return result;
}

}  // namespace geneva::post
