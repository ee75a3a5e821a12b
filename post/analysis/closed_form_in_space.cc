#include "post/analysis/closed_form_in_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loads/contact_limits.h"
#include "post/analysis/friction.h"
#include "post/analysis/surface_body.h"

namespace geneva::post {

using dealii::Point;
using dealii::SymmetricTensor;
using dealii::Tensor;

namespace {

/// Up to which relative change of its second difference a profile counts as a parabola.
constexpr double parabolic = 0.05;

}  // namespace

double ClosedFormInSpace::peak_pressure() const {
  return line ? line->peak_pressure : ellipse->peak_pressure;
}

double ClosedFormInSpace::half_width() const {
  if (line) return line->half_width;
  return radius_along < radius_across ? ellipse->semi_axis_long : ellipse->semi_axis_short;
}

double ClosedFormInSpace::half_length() const {
  if (line) return length / 2.;
  return radius_along < radius_across ? ellipse->semi_axis_short : ellipse->semi_axis_long;
}

std::optional<double> ClosedFormInSpace::max_shear() const {
  if (friction != 0.) return std::nullopt;
  if (line) return line->max_shear;
  return is_circle() ? std::optional(as_point().max_shear) : std::nullopt;
}

std::optional<double> ClosedFormInSpace::max_shear_depth() const {
  if (friction != 0.) return std::nullopt;
  if (line) return line->max_shear_depth;
  return is_circle() ? std::optional(as_point().max_shear_depth) : std::nullopt;
}

bool ClosedFormInSpace::is_circle() const {
  return ellipse && std::abs(radius_along / radius_across - 1.) < 1e-6;
}

bool ClosedFormInSpace::is_on_line(const double along) const {
  return std::abs(along - middle) <= length / 2. * (1. + 1e-9);
}

loads::HertzPoint ClosedFormInSpace::as_point() const {
  return loads::hertz_point(force, radius_across, contact_modulus, poissons_ratio);
}

double ClosedFormInSpace::pressure(const double across, const double along) const {
  if (line) return is_on_line(along) ? line->pressure(across) : 0.;
  const double x = across / half_width();
  const double z = along / half_length();
  return ellipse->peak_pressure * std::sqrt(std::max(0., 1. - x * x - z * z));
}

std::optional<SymmetricTensor<2, 3>> mcewen_stress(const ClosedFormInSpace& form,
                                                   const ContactFrame& frame,
                                                   const double poissons_ratio,
                                                   const Point<3>& place) {
  if (!form.line || !form.is_on_line(frame.distance_along(place))) return std::nullopt;
  const double b = form.line->half_width;
  const double x = frame.distance_across(place);
  const double z = frame.depth(place);
  if (std::abs(x) >= 4. * b || z >= 6. * b) return std::nullopt;
  const double side = (place - frame.centre) * frame.normal < 0. ? -1. : 1.;
  const loads::ContactStress local = loads::sliding_stress(*form.line, -side * form.friction, x, z);
  const Tensor<1, 3> inward = side * frame.normal;
  return local.xx * symmetrize(outer_product(frame.across, frame.across)) +
         local.zz * symmetrize(outer_product(inward, inward)) +
         2. * local.xz * symmetrize(outer_product(frame.across, inward)) +
         poissons_ratio * (local.xx + local.zz) *
             symmetrize(outer_product(frame.along, frame.along));
}

std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame) {
  if (frame.normal.norm() == 0.) return std::nullopt;
  ClosedFormInSpace form{};
  const auto [first, last] = loaded_extent(contact, frame, frame.along);
  form.length = last - first;
  form.middle = (first + last) / 2. - Tensor<1, 3>(frame.centre) * frame.along;
  for (unsigned int i = 0; i < 3; ++i) form.force += contact.force[i] * frame.normal[i];
  form.force = frame.parts() * std::abs(form.force);
  if (frame.curvature_across * solution.scales.length <= 1e-9 || form.length <= 0.)
    return std::nullopt;
  const loads::Elastic source = material_of(solution, contact.source);
  const loads::Elastic target = material_of(solution, contact.target);
  form.radius_across = 1. / frame.curvature_across;
  form.radius_along = std::numeric_limits<double>::infinity();
  form.poissons_ratio = std::min(source.poissons_ratio, target.poissons_ratio);
  form.contact_modulus = loads::contact_modulus(source, target);
  form.friction = sliding_friction(solution, contact, frame.across);
  const auto [lowest, highest] = whole_extent(contact, frame, frame.along);
  form.even =
      loads::hertz_line(form.force / (highest - lowest), form.radius_across, form.contact_modulus);
  if (frame.curvature_along * form.length > 1e-9) {
    const double along = 1. / frame.curvature_along;
    form.radius_along = along;
    form.ellipse = loads::hertz_ellipse(form.force, std::max(form.radius_across, along),
                                        std::min(form.radius_across, along), form.contact_modulus);
    // Hertz's ellipse needs a profile that is a parabola as far as the contact reaches, and a
    // contact that ends before the surfaces do.
    const fem::ContactPair& pair = pair_of(solution, contact);
    const double half_length = form.half_length();
    const double middle = Tensor<1, 3>(frame.centre) * frame.along;
    const double reach = std::min(middle - lowest, highest - middle);
    const double change = second_difference(pair, frame.centre[2], half_length) -
                          second_difference(pair, frame.centre[2], 0.02 * form.length);
    if (std::abs(change * along) < parabolic && half_length < reach) return form;
    form.radius_along = std::numeric_limits<double>::infinity();
    form.ellipse.reset();
  }
  form.line = loads::hertz_line(form.force / form.length, form.radius_across, form.contact_modulus);
  return form;
}

}  // namespace geneva::post
