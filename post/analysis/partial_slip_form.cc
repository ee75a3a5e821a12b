#include "post/analysis/partial_slip_form.h"

#include <algorithm>
#include <cmath>

#include "post/analysis/surface_body.h"

namespace geneva::post {

namespace {

using Shape = loads::PartialSlip::Shape;

/// Shares that are taken for nothing.
constexpr double negligible = 1e-3;

std::optional<Shape> shape_of(const fem::Solution<2>& solution,
                              const ContactAnalysis<2>& analysis) {
  const bool is_plane = solution.problem.plane != fem::PlaneKind::axisymmetric;
  if (!is_plane || !analysis.hertz || !analysis.hertz->line) return std::nullopt;
  return Shape::line;
}

std::optional<Shape> shape_of(const fem::Solution<3>& /*solution*/,
                              const ContactAnalysis<3>& analysis) {
  if (!analysis.hertz || !analysis.hertz->is_circle()) return std::nullopt;
  return Shape::circle;
}

/// Whether pressure moves the surfaces of both bodies along each other: (1 - 2 nu)/G differs.
template <int dim>
bool are_alike(const fem::Solution<dim>& solution, const fem::ContactResult<dim>& contact) {
  const auto lateral = [&](const std::string& surface) {
    const loads::Elastic material = material_of(solution, surface);
    return (1. - 2. * material.poissons_ratio) * (1. + material.poissons_ratio) /
           material.youngs_modulus;
  };
  const double one = lateral(contact.source);
  const double other = lateral(contact.target);
  return std::abs(one - other) <= negligible * (one + other);
}

template <int dim>
dealii::Tensor<1, dim> vector_of(const fem::Components<dim>& components) {
  dealii::Tensor<1, dim> vector;
  for (unsigned int i = 0; i < dim; ++i) vector[i] = components[i];
  return vector;
}

/// Along the greatest friction of all steps; nothing where there is none.
template <int dim>
std::optional<dealii::Tensor<1, dim>> direction_of(const fem::Solution<dim>& solution,
                                                   const std::size_t pair) {
  dealii::Tensor<1, dim> greatest;
  for (const fem::Instant<dim>& instant : solution.instants) {
    const auto friction = vector_of<dim>(instant.pairs[pair].friction_force);
    if (friction.norm() > greatest.norm()) greatest = friction;
  }
  if (greatest.norm() == 0.) return std::nullopt;
  return greatest / greatest.norm();
}

double distance_over_radius(const ContactAnalysis<2>& analysis, const fem::ContactNode<2>& node) {
  return std::abs(node.arc_length - analysis.hertz->centre_arc_length) /
         analysis.hertz->half_width();
}

double distance_over_radius(const ContactAnalysis<3>& analysis, const fem::ContactNode<3>& node) {
  const dealii::Point<3> place(node.position[0], node.position[1], node.position[2]);
  return std::hypot(analysis.frame.distance_across(place), analysis.frame.distance_along(place)) /
         analysis.hertz->half_width();
}

}  // namespace

template <int dim>
double PartialSlipForm<dim>::traction(const ContactAnalysis<dim>& analysis,
                                      const fem::ContactNode<dim>& node) const {
  return bound * slip.traction(distance_over_radius(analysis, node));
}

template <int dim>
std::optional<PartialSlipForm<dim>> partial_slip(const fem::Solution<dim>& solution,
                                                 const std::size_t pair,
                                                 const ContactAnalysis<dim>& analysis) {
  const fem::ContactResult<dim>& contact = solution.contacts[pair];
  const fem::Friction& friction = solution.problem.pairs[pair].friction;
  const auto shape = shape_of(solution, analysis);
  if (!shape || friction.coefficient == 0. || friction.slides() || solution.instants.empty() ||
      !are_alike(solution, contact))
    return std::nullopt;
  const auto direction = direction_of(solution, pair);
  if (!direction) return std::nullopt;
  const double pressed = fem::magnitude(solution.instants.back().pairs[pair].force);
  const double bound = friction.coefficient * pressed;
  PartialSlipForm<dim> form{loads::PartialSlip(*shape, bound),
                            friction.coefficient * analysis.hertz->peak_pressure(), *direction};
  bool was_pressed = false;  // by the whole force, before anything moves it
  for (const fem::Instant<dim>& instant : solution.instants) {
    const auto dragged = vector_of<dim>(instant.pairs[pair].friction_force);
    const double along = dragged * *direction;
    const bool is_moved = std::abs(along) > negligible * bound;
    const bool is_pressed = was_pressed && std::abs(fem::magnitude(instant.pairs[pair].force) -
                                                    pressed) <= negligible * pressed;
    if ((is_moved && !is_pressed) ||
        (dragged - along * *direction).norm() > 10. * negligible * bound)
      return std::nullopt;
    if (is_moved) form.slip.move_to(along);
    was_pressed = was_pressed || (std::abs(fem::magnitude(instant.pairs[pair].force) - pressed) <=
                                  negligible * pressed);
  }
  return form;
}

template struct PartialSlipForm<2>;
template struct PartialSlipForm<3>;
template std::optional<PartialSlipForm<2>> partial_slip(const fem::Solution<2>&, std::size_t,
                                                        const ContactAnalysis<2>&);
template std::optional<PartialSlipForm<3>> partial_slip(const fem::Solution<3>&, std::size_t,
                                                        const ContactAnalysis<3>&);

}  // namespace geneva::post
