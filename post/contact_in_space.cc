#include "post/contact_in_space.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fem/symmetry.h"

namespace geneva::post {

using dealii::Point;
using dealii::Tensor;

namespace {

using Node = fem::ContactNode<3>;

/// Up to which relative change of its second difference a profile counts as a parabola.
constexpr double parabolic = 0.05;

Point<3> place_of(const Node& node) {
  return {node.position[0], node.position[1], node.position[2]};
}

const Tensor<1, 3> z_axis({0., 0., 1.});

/// Lowest and highest place along a direction where the surfaces face each other.
std::pair<double, double> extent_along(const fem::ContactResult<3>& contact,
                                       const Tensor<1, 3>& direction) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes) {
    const double place = Tensor<1, 3>(place_of(node)) * direction;
    lowest = std::min(lowest, place);
    highest = std::max(highest, place);
  }
  return {lowest, highest};
}

/// Nodes of one layer, in their order across the contact.
using Layer = std::vector<const Node*>;

/// Layers with a node in contact, by ascending z.
std::vector<Layer> loaded_layers(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = extent_along(contact, z_axis);
  const double same = 1e-9 * (highest - lowest);
  Layer all;
  for (const Node& node : contact.nodes) all.push_back(&node);
  std::sort(all.begin(), all.end(),
            [](const Node* a, const Node* b) { return a->position[2] < b->position[2]; });
  std::vector<Layer> layers;
  for (const Node* node : all) {
    if (layers.empty() || node->position[2] - layers.back().front()->position[2] > same)
      layers.emplace_back();
    layers.back().push_back(node);
  }
  layers.erase(std::remove_if(layers.begin(), layers.end(),
                              [](const Layer& layer) {
                                return std::none_of(layer.begin(), layer.end(),
                                                    [](const Node* n) { return n->active; });
                              }),
               layers.end());
  for (Layer& layer : layers)
    std::sort(layer.begin(), layer.end(), [&](const Node* a, const Node* b) {
      return frame.distance_across(place_of(*a)) < frame.distance_across(place_of(*b));
    });
  return layers;
}

/// Integrals of the pressure across a layer by the trapezoidal rule, exact for linear pressure.
ContactSection section_of(const Layer& layer, const ContactFrame& frame) {
  ContactSection section{layer.front()->position[2], 0., 0., 0., 0., 0.};
  double first = 0.;
  double second = 0.;
  for (std::size_t i = 0; i < layer.size(); ++i) {
    section.peak_pressure = std::max(section.peak_pressure, layer[i]->pressure);
    if (i == 0) continue;
    const double length = place_of(*layer[i]).distance(place_of(*layer[i - 1]));
    for (const Node* node : {layer[i - 1], layer[i]}) {
      const double share = length / 2. * node->pressure;
      const double s = frame.distance_across(place_of(*node));
      section.line_load += share;
      first += share * s;
      second += share * s * s;
    }
  }
  if (section.line_load <= 0.) return section;
  const double mean = first / section.line_load;
  section.half_width = 2. * std::sqrt(std::max(0., second / section.line_load - mean * mean));
  return section;
}

/// The greatest shear in this rank's cells below each section, and its depth.
using ShearBySection = std::vector<std::pair<double, double>>;

/// A cell counts for every section that passes through it.
ShearBySection shear_below(const std::vector<ContactSection>& sections, const ContactFrame& frame,
                           const std::vector<CellStress<3>>& cells) {
  ShearBySection greatest(sections.size(), {0., 0.});
  double widest = 0.;
  for (const ContactSection& section : sections) widest = std::max(widest, section.half_width);
  for (const CellStress<3>& cell : cells) {
    const double depth = frame.depth(cell.centre);
    if (depth > 3. * widest || std::abs(frame.distance_across(cell.centre)) > 2. * widest) continue;
    const double reach = 0.5 * cell.height * (1. + 1e-9);
    const std::pair entry(max_shear(principal_stresses(cell.stress)), depth);
    const auto first = std::lower_bound(
        sections.begin(), sections.end(), cell.centre[2] - reach,
        [](const ContactSection& section, const double z) { return section.z < z; });
    for (auto section = first; section != sections.end() && section->z <= cell.centre[2] + reach;
         ++section) {
      auto& found = greatest[static_cast<std::size_t>(section - sections.begin())];
      found = std::max(found, entry);
    }
  }
  return greatest;
}

void add_shear(std::vector<ContactSection>& sections, const MPI_Comm communicator,
               const ShearBySection& local) {
  for (const ShearBySection& part : dealii::Utilities::MPI::all_gather(communicator, local))
    for (std::size_t i = 0; i < sections.size(); ++i)
      if (part[i].first > sections[i].max_shear)
        std::tie(sections[i].max_shear, sections[i].max_shear_depth) = part[i];
}

/// Body that a surface bounds.
unsigned int body_of(const fem::Solution<3>& solution, const std::string& surface) {
  const auto& names = solution.mesh.surfaces;
  const auto id =
      static_cast<unsigned int>(std::find(names.begin(), names.end(), surface) - names.begin());
  return *mesh::bodies_of(solution.mesh, id).begin();
}

loads::Elastic material_of(const fem::Solution<3>& solution, const std::string& surface) {
  const fem::Material& material = solution.problem.bodies[body_of(solution, surface)].material;
  return {material.youngs_modulus, material.poissons_ratio};
}

/// Curvatures of a surface in the directions of its tangent plane, positive where it bulges [1/m].
Tensor<2, 3> curvatures(const fem::Solution<3>& solution, const int circle, const bool is_convex,
                        const Tensor<1, 3>& normal) {
  Tensor<2, 3> tensor;
  if (circle < 0) return tensor;
  const mesh::Circle& shape = solution.mesh.circles[static_cast<std::size_t>(circle)];
  const Tensor<1, 3> axis({shape.axis[0], shape.axis[1], shape.axis[2]});
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k)
      tensor[i][k] = (i == k ? 1. : 0.) - normal[i] * normal[k] - axis[i] * axis[k];
  return (is_convex ? 1. : -1.) / shape.radius * tensor;
}

const fem::ContactPair& pair_of(const fem::Solution<3>& solution,
                                const fem::ContactResult<3>& contact) {
  return *std::find_if(solution.problem.pairs.begin(), solution.problem.pairs.end(),
                       [&](const fem::ContactPair& pair) { return pair.source == contact.source; });
}

/// Second difference of a clearance over a distance to both sides.
double second_difference(const fem::ContactPair& pair, const double z, const double step) {
  if (!pair.clearance) return 0.;
  return (pair.clearance(z + step) - 2. * pair.clearance(z) + pair.clearance(z - step)) /
         (step * step);
}

/// Length along a direction over which the contact carries load.
double loaded_length(const fem::ContactResult<3>& contact, const Tensor<1, 3>& direction) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes)
    if (node.active) {
      const double place = Tensor<1, 3>(place_of(node)) * direction;
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
    }
  return highest - lowest;
}

/// The same with the part of the contact that a plane of symmetry has cut off.
std::pair<double, double> whole_extent(const fem::ContactResult<3>& contact,
                                       const ContactFrame& frame, const Tensor<1, 3>& direction) {
  const auto [lowest, highest] = extent_along(contact, direction);
  if (!frame.is_mirrored(direction)) return {lowest, highest};
  const double plane = Tensor<1, 3>(frame.centre) * direction;
  const double reach = std::max(plane - lowest, highest - plane);
  return {plane - reach, plane + reach};
}

/// The sections and their images beyond the plane of symmetry z = plane.
std::vector<ContactSection> mirrored(const std::vector<ContactSection>& sections,
                                     const double plane) {
  std::vector<ContactSection> all = sections;
  double length = 0.;
  for (const ContactSection& section : sections)
    length = std::max(length, std::abs(section.z - plane));
  for (ContactSection section : sections) {
    if (std::abs(section.z - plane) <= 1e-9 * length) continue;
    section.z = 2. * plane - section.z;
    all.push_back(section);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  return all;
}

/// Directions of the least and the greatest curvature in the tangent plane; along z where both are
/// equal, or where only the gap's clearance curves along z.
void set_directions(ContactFrame& frame, const Tensor<2, 3>& curvature, const bool is_along_z) {
  const Tensor<1, 3> x_axis({1., 0., 0.});
  const Tensor<1, 3>& start = std::abs(frame.normal[2]) < 0.9 ? z_axis : x_axis;
  frame.along = start - (start * frame.normal) * frame.normal;
  frame.along /= frame.along.norm();
  frame.across = dealii::cross_product_3d(frame.normal, frame.along);
  const double mixed = frame.across * (curvature * frame.along);
  const double excess =
      frame.across * (curvature * frame.across) - frame.along * (curvature * frame.along);
  const double rounding = 1e-6 * curvature.norm();
  if (is_along_z || (std::abs(mixed) <= rounding && excess >= -rounding)) return;
  // the tensor's principal directions are those of the angle with tan 2 angle = 2 mixed/excess
  const double angle = std::atan2(2. * mixed, excess) / 2.;
  const Tensor<1, 3> across = std::cos(angle) * frame.across + std::sin(angle) * frame.along;
  frame.along = dealii::cross_product_3d(across, frame.normal);
  frame.across = across;
}

}  // namespace

double ContactFrame::depth(const Point<3>& place) const {
  return std::abs((place - centre) * normal);
}

double ContactFrame::distance_across(const Point<3>& place) const {
  return (place - centre) * across;
}

double ContactFrame::distance_along(const Point<3>& place) const {
  return (place - centre) * along;
}

double ContactFrame::parts() const {
  return std::pow(2., std::count(mirrored.begin(), mirrored.end(), true));
}

bool ContactFrame::is_mirrored(const Tensor<1, 3>& direction) const {
  for (unsigned int i = 0; i < 3; ++i)
    if (mirrored[i] && std::abs(direction[i]) > 1. - 1e-6) return true;
  return false;
}

ContactFrame contact_frame(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact) {
  ContactFrame frame{};
  double force = 0.;
  Tensor<1, 3> place;
  for (const Node& node : contact.nodes) {
    const double share = node.pressure * node.tributary;
    force += share;
    place += share * Tensor<1, 3>(place_of(node));
    for (unsigned int i = 0; i < 3; ++i) frame.normal[i] += share * node.normal[i];
  }
  if (force <= 0.) return frame;
  frame.centre = Point<3>(place / force);
  for (unsigned int i = 0; i < 3; ++i)
    if (const auto plane = fem::symmetry_plane(solution.mesh, solution.problem, contact, i)) {
      frame.mirrored[i] = true;
      frame.centre[i] = *plane;
      frame.normal[i] = 0.;
    }
  frame.normal /= frame.normal.norm();
  const Tensor<2, 3> curvature =
      curvatures(solution, contact.source_circle, contact.source_is_convex, frame.normal) +
      curvatures(solution, contact.target_circle, contact.target_is_convex, frame.normal);
  const fem::ContactPair& pair = pair_of(solution, contact);
  set_directions(frame, curvature, static_cast<bool>(pair.clearance));
  const double step = 0.02 * loaded_length(contact, frame.along);
  frame.curvature_across = frame.across * (curvature * frame.across);
  frame.curvature_along = frame.along * (curvature * frame.along) +
                          (step > 0. ? second_difference(pair, frame.centre[2], step) : 0.);
  for (const Node& node : contact.nodes) {
    const double share = node.pressure * node.tributary / force;
    const double across = frame.distance_across(place_of(node));
    const double along = frame.distance_along(place_of(node));
    frame.mean_square_across += share * across * across;
    frame.mean_square_along += share * along * along;
  }
  return frame;
}

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
  if (line) return line->max_shear;
  return is_circle() ? std::optional(as_point().max_shear) : std::nullopt;
}

std::optional<double> ClosedFormInSpace::max_shear_depth() const {
  if (line) return line->max_shear_depth;
  return is_circle() ? std::optional(as_point().max_shear_depth) : std::nullopt;
}

bool ClosedFormInSpace::is_circle() const {
  return ellipse && std::abs(radius_along / radius_across - 1.) < 1e-6;
}

loads::HertzPoint ClosedFormInSpace::as_point() const {
  return loads::hertz_point(force, radius_across, contact_modulus, poissons_ratio);
}

double ClosedFormInSpace::pressure(const double across, const double along) const {
  if (line) return std::abs(along) <= length / 2. * (1. + 1e-9) ? line->pressure(across) : 0.;
  const double x = across / half_width();
  const double z = along / half_length();
  return ellipse->peak_pressure * std::sqrt(std::max(0., 1. - x * x - z * z));
}

std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame) {
  if (frame.normal.norm() == 0.) return std::nullopt;
  ClosedFormInSpace form{};
  form.length = loaded_length(contact, frame.along);
  if (frame.is_mirrored(frame.along)) form.length *= 2.;
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

std::vector<ContactSection> contact_sections(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame,
                                             const std::vector<CellStress<3>>& cells) {
  std::vector<ContactSection> sections;
  if (std::abs(frame.along * z_axis) < 1. - 1e-6) return sections;
  const std::vector<Layer> layers = loaded_layers(contact, frame);
  for (const Layer& layer : layers)
    if (layer.size() > 1) sections.push_back(section_of(layer, frame));
  if (2 * sections.size() < layers.size()) return {};
  add_shear(sections, solution.dof_handler->get_communicator(),
            shear_below(sections, frame, cells));
  return frame.is_mirrored(z_axis) ? mirrored(sections, frame.centre[2]) : sections;
}

ShearBelow greatest_shear(const fem::Solution<3>& solution, const ContactFrame& frame,
                          const double half_width, const std::vector<CellStress<3>>& cells) {
  std::pair<double, double> greatest(0., 0.);
  for (const CellStress<3>& cell : cells) {
    const double depth = frame.depth(cell.centre);
    const double aside =
        std::hypot(frame.distance_across(cell.centre), frame.distance_along(cell.centre));
    if (depth > 3. * half_width || aside > 2. * half_width) continue;
    greatest = std::max(greatest, std::pair(max_shear(principal_stresses(cell.stress)), depth));
  }
  for (const auto& of_rank :
       dealii::Utilities::MPI::all_gather(solution.dof_handler->get_communicator(), greatest))
    greatest = std::max(greatest, of_rank);
  return {greatest.first, greatest.second};
}

const ContactSection& middle_section(const fem::ContactResult<3>& contact,
                                     const ContactFrame& frame,
                                     const std::vector<ContactSection>& sections) {
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  const double middle = (lowest + highest) / 2.;
  if (sections.empty()) throw std::invalid_argument("a contact without load has no middle section");
  return *std::min_element(sections.begin(), sections.end(),
                           [&](const ContactSection& a, const ContactSection& b) {
                             return std::abs(a.z - middle) < std::abs(b.z - middle);
                           });
}

double common_length(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  return highest - lowest;
}

LineLoad line_load(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                   const std::vector<ContactSection>& sections) {
  if (sections.empty()) return {0., 0.};
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  const double near = 1e-6 * (highest - lowest);
  LineLoad load{middle_section(contact, frame, sections).line_load, 0.};
  for (const ContactSection* end : {&sections.front(), &sections.back()})
    if (end->z < lowest + near || end->z > highest - near)
      load.end = std::max(load.end, end->line_load);
  return load;
}

}  // namespace geneva::post
