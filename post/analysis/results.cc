#include "post/analysis/results.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/analysis/hertz_objection.h"

namespace geneva::post {

using dealii::Point;

namespace {

template <int dim>
double norm(const fem::Components<dim>& vector) {
  double square = 0.;
  for (const double component : vector) square += component * component;
  return std::sqrt(square);
}

double norm(const double moment) { return std::abs(moment); }
double norm(const dealii::Tensor<1, 3>& moment) { return moment.norm(); }

/// What forces are compared with: the contact force, or without contact the maximum stress on the
/// square of the model's extent, in the plane on extent times thickness [N].
template <int dim>
double force_scale(const fem::Solution<dim>& solution,
                   const std::vector<StressPeak<dim>>& max_von_mises) {
  double scale = 0.;
  for (const fem::ContactResult<dim>& contact : solution.contacts)
    scale = std::max(scale, std::hypot(norm<dim>(contact.force), norm<dim>(contact.lateral_force)));
  if (fem::has_contact(solution.problem)) return scale;
  const double extent = solution.scales.length;
  const bool has_thickness = dim == 2 && solution.problem.plane != fem::PlaneKind::axisymmetric;
  for (const StressPeak<dim>& peak : max_von_mises)
    scale = std::max(scale,
                     peak.value * extent * (has_thickness ? solution.problem.thickness : extent));
  return scale;
}

template <int dim>
Equilibrium equilibrium(const fem::Solution<dim>& solution, const double scale) {
  const bool axisymmetric = dim == 2 && solution.problem.plane == fem::PlaneKind::axisymmetric;
  fem::Components<dim> force = solution.applied_force;
  fem::Moment<dim> moment = solution.applied_moment;
  moment += solution.contact_couple;
  for (const fem::Reaction<dim>& reaction : solution.reactions) {
    for (unsigned int i = 0; i < dim; ++i) force[i] += reaction.force[i];
    moment += reaction.moment;
  }
  if (scale == 0.) return {0., 0.};
  const double residual = axisymmetric ? std::abs(force[1]) : norm<dim>(force);
  const double arm = solution.scales.length;
  return {residual / scale, axisymmetric ? 0. : norm(moment) / (scale * arm)};
}

/// Where the maximum shear of a contact is looked for, and how it is measured.
struct ShearZone {
  Point<2> centre;
  double half_width;  ///< of Hertz's pressure, or one like it [m]
};

/// Around the top of the pressure, on a scale as if it were Hertz's, who has p0/2 at sqrt(3)/2 b.
ShearZone zone_of_top(const fem::ContactResult<2>& contact) {
  const auto& nodes = contact.nodes;
  const auto top = std::max_element(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) {
    return a.pressure < b.pressure;
  });
  const auto is_low = [&](const auto& node) { return node.pressure < 0.5 * top->pressure; };
  const auto end = std::find_if(top, nodes.end(), is_low) - 1;
  const auto begin = std::find_if(std::make_reverse_iterator(top), nodes.rend(), is_low).base();
  return {Point<2>(top->position[0], top->position[1]),
          (end->arc_length - begin->arc_length) / std::sqrt(3.)};
}

double distance_from(const fem::ContactResult<2>& contact, const Point<2>& place) {
  double nearest = std::numeric_limits<double>::max();
  for (const fem::ContactNode<2>& node : contact.nodes)
    nearest = std::min(nearest, place.distance(Point<2>(node.position[0], node.position[1])));
  return nearest;
}

/// Sets the maximum shear below the contact, or with much friction at its surface, and its depth.
void set_shear(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact,
               const std::vector<CellStress<2>>& cells, ContactAnalysis<2>& analysis) {
  const ShearZone zone = contact.has_one_curvature
                             ? ShearZone{analysis.centre.place, contact.half_width}
                             : zone_of_top(contact);
  const double half_width = std::max(zone.half_width, 1e-12 * solution.scales.length);
  const auto depth = [&] {
    const Point<2> place(analysis.max_shear.place[0], analysis.max_shear.place[1]);
    return contact.has_one_curvature
               ? std::abs((place - analysis.centre.place) * analysis.centre.normal)
               : distance_from(contact, place);
  };
  const auto find_top = [&](const double radius) {
    analysis.max_shear = peak_shear(solution, cells, zone.centre, 3. * half_width, radius);
  };
  find_top(0.45 * half_width);
  // Friction brings the top near the surface, where the field changes over shorter ways.
  constexpr double of_depth = 0.5;
  if (analysis.surface && of_depth * depth() < 0.45 * half_width) find_top(of_depth * depth());
  if (analysis.surface && analysis.surface->shear > analysis.max_shear.value)
    analysis.max_shear = {analysis.surface->shear, analysis.surface->shear_place};
  analysis.max_shear_depth = depth();
}

/// What is drawn and compared beside the figures.
void add_fields(ContactAnalysis<2>& analysis, const fem::Solution<2>& solution,
                const fem::ContactResult<2>& contact, const NodalStress<2>& nodal) {
  if (analysis.hertz) analysis.difference = field_difference(solution, *analysis.hertz, nodal);
  analysis.depth_line = depth_line(solution, contact, analysis.centre, analysis.hertz, nodal);
}

void add_fields(ContactAnalysis<3>& /*unused*/, const fem::Solution<3>& /*unused*/,
                const fem::ContactResult<3>& /*unused*/, const NodalStress<3>& /*unused*/) {}

}  // namespace

ContactAnalysis<2> contact_analysis(const fem::Solution<2>& solution,
                                    const fem::ContactResult<2>& contact,
                                    const std::vector<CellStress<2>>& cells) {
  ContactAnalysis<2> analysis{};
  analysis.centre = pressure_centre(solution, contact);
  analysis.hertz_objection = hertz_objection(solution, contact, contact.half_width);
  if (analysis.hertz_objection.empty()) analysis.hertz = closed_form(solution, contact);
  analysis.surface = surface_extremes(solution, contact);
  set_shear(solution, contact, cells, analysis);
  return analysis;
}

ContactAnalysis<3> contact_analysis(const fem::Solution<3>& solution,
                                    const fem::ContactResult<3>& contact,
                                    const std::vector<CellStress<3>>& cells) {
  ContactAnalysis<3> analysis{};
  analysis.frame = contact_frame(solution, contact);
  if (analysis.frame.normal.norm() == 0.) return analysis;
  analysis.hertz_objection =
      hertz_objection(solution, contact, 2. * std::sqrt(analysis.frame.mean_square_across));
  if (analysis.hertz_objection.empty())
    analysis.hertz = closed_form(solution, contact, analysis.frame);
  analysis.sections = contact_sections(solution, contact, analysis.frame, cells);
  const auto peak =
      std::max_element(contact.nodes.begin(), contact.nodes.end(),
                       [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
  analysis.peak_place = peak->position;
  // A semi-ellipsoid of pressure has the mean squares a^2/5 and b^2/5, a semi-ellipse b^2/4.
  if (analysis.sections.empty() || (analysis.hertz && analysis.hertz->ellipse)) {
    const bool is_line = analysis.hertz && analysis.hertz->line;
    analysis.half_width = std::sqrt((is_line ? 4. : 5.) * analysis.frame.mean_square_across);
    analysis.half_length = std::sqrt((is_line ? 3. : 5.) * analysis.frame.mean_square_along);
    const ShearBelow shear = maximum_shear(solution, analysis.frame, analysis.half_width, cells);
    analysis.max_shear = shear.value;
    analysis.max_shear_depth = shear.depth;
    return analysis;
  }
  analysis.half_width = middle_section(contact, analysis.frame, analysis.sections).half_width;
  analysis.half_length = (analysis.sections.back().z - analysis.sections.front().z) / 2.;
  for (const ContactSection& section : analysis.sections)
    if (section.max_shear > analysis.max_shear) {
      analysis.max_shear = section.max_shear;
      analysis.max_shear_depth = section.max_shear_depth;
    }
  return analysis;
}

double half_width(const fem::ContactResult<2>& contact, const ContactAnalysis<2>& /*unused*/) {
  return contact.half_width;
}
double half_width(const fem::ContactResult<3>& /*unused*/, const ContactAnalysis<3>& analysis) {
  return analysis.half_width;
}

double hertz_pressure(const ContactAnalysis<2>& analysis, const fem::ContactNode<2>& node) {
  return analysis.hertz ? analysis.hertz->pressure(node.arc_length)
                        : std::numeric_limits<double>::quiet_NaN();
}

double hertz_pressure(const ContactAnalysis<3>& analysis, const fem::ContactNode<3>& node) {
  if (!analysis.hertz) return std::numeric_limits<double>::quiet_NaN();
  const Point<3> place = place_of(node);
  return analysis.hertz->pressure(analysis.frame.distance_across(place),
                                  analysis.frame.distance_along(place));
}

template <int dim>
bool is_bounded(const fem::Solution<dim>& solution) {
  return (!solution.edge || solution.edge->is_bounded) &&
         solution.stop.outcome != fem::Outcome::unbounded_pressure;
}

template <int dim>
std::size_t leading_contact(const fem::Solution<dim>& solution) {
  const auto leading = std::max_element(
      solution.contacts.begin(), solution.contacts.end(),
      [](const auto& a, const auto& b) { return a.peak_pressure < b.peak_pressure; });
  return static_cast<std::size_t>(leading - solution.contacts.begin());
}

template <int dim>
Results<dim> analyse(const fem::Solution<dim>& solution) {
  Results<dim> results;
  results.cells = cell_stresses(solution);
  results.nodal = nodal_stress(solution);
  for (const fem::ContactResult<dim>& contact : solution.contacts) {
    results.contacts.push_back(contact_analysis(solution, contact, results.cells));
    add_fields(results.contacts.back(), solution, contact, results.nodal);
  }
  for (unsigned int body = 0; body < solution.problem.bodies.size(); ++body)
    results.max_von_mises.push_back(peak_von_mises(solution, results.nodal, body));
  results.equilibrium = equilibrium(solution, force_scale(solution, results.max_von_mises));
  return results;
}

template bool is_bounded(const fem::Solution<2>&);
template bool is_bounded(const fem::Solution<3>&);
template std::size_t leading_contact(const fem::Solution<2>&);
template std::size_t leading_contact(const fem::Solution<3>&);
template Results<2> analyse(const fem::Solution<2>&);
template Results<3> analyse(const fem::Solution<3>&);

}  // namespace geneva::post
