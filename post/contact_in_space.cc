#include "post/contact_in_space.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

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

/// Lowest and highest place along z where the surfaces face each other.
std::pair<double, double> extent_along(const fem::ContactResult<3>& contact) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes) {
    lowest = std::min(lowest, node.position[2]);
    highest = std::max(highest, node.position[2]);
  }
  return {lowest, highest};
}

/// Nodes of one layer, in their order across the contact.
using Layer = std::vector<const Node*>;

/// Layers with a node in contact, by ascending z.
std::vector<Layer> loaded_layers(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = extent_along(contact);
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

loads::Elastic material_of(const fem::Solution<3>& solution, const std::string& surface) {
  const auto& names = solution.mesh.surfaces;
  const auto id =
      static_cast<unsigned int>(std::find(names.begin(), names.end(), surface) - names.begin());
  const unsigned int body = *mesh::bodies_of(solution.mesh, id).begin();
  const fem::Material& material = solution.problem.bodies[body].material;
  return {material.youngs_modulus, material.poissons_ratio};
}

/// 1/R of a cylinder along z, across it.
double curvature(const fem::Solution<3>& solution, const int circle, const bool is_convex) {
  if (circle < 0) return 0.;
  const double radius = solution.mesh.circles[static_cast<std::size_t>(circle)].radius;
  return is_convex ? 1. / radius : -1. / radius;
}

/// Second difference of the clearance along z over a distance to both sides.
double curvature_along(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact,
                       const double z, const double step) {
  for (const fem::ContactPair& pair : solution.problem.pairs)
    if (pair.source == contact.source && pair.clearance)
      return (pair.clearance(z + step) - 2. * pair.clearance(z) + pair.clearance(z - step)) /
             (step * step);
  return 0.;
}

/// Length along z over which the contact carries load.
double loaded_length(const fem::ContactResult<3>& contact) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes)
    if (node.active) {
      lowest = std::min(lowest, node.position[2]);
      highest = std::max(highest, node.position[2]);
    }
  return highest - lowest;
}

}  // namespace

double ContactFrame::depth(const Point<3>& place) const {
  return std::abs((place - centre) * normal);
}

double ContactFrame::distance_across(const Point<3>& place) const {
  return (place - centre) * across;
}

ContactFrame contact_frame(const fem::ContactResult<3>& contact) {
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
  frame.normal /= frame.normal.norm();
  frame.across = dealii::cross_product_3d(frame.normal, Tensor<1, 3>({0., 0., 1.}));
  if (frame.across.norm() < 1e-6) frame.across = Tensor<1, 3>({1., 0., 0.});
  frame.across /= frame.across.norm();
  for (const Node& node : contact.nodes) {
    const double share = node.pressure * node.tributary / force;
    const Tensor<1, 3> arm = place_of(node) - frame.centre;
    frame.mean_square_across += share * (arm * frame.across) * (arm * frame.across);
    frame.mean_square_along += share * arm[2] * arm[2];
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

double ClosedFormInSpace::pressure(const double across, const double along) const {
  if (line) return std::abs(along) <= length / 2. * (1. + 1e-9) ? line->pressure(across) : 0.;
  const double x = across / half_width();
  const double z = along / half_length();
  return ellipse->peak_pressure * std::sqrt(std::max(0., 1. - x * x - z * z));
}

std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact) {
  const ContactFrame frame = contact_frame(contact);
  if (frame.normal.norm() == 0.) return std::nullopt;
  ClosedFormInSpace form{};
  form.length = loaded_length(contact);
  for (const double component : contact.force) form.force += component * component;
  form.force = std::sqrt(form.force);
  const double across = curvature(solution, contact.source_circle, contact.source_is_convex) +
                        curvature(solution, contact.target_circle, contact.target_is_convex);
  const double z = frame.centre[2];
  const double along = curvature_along(solution, contact, z, 0.02 * form.length);
  if (across * solution.scales.length <= 1e-9 || form.length <= 0.) return std::nullopt;
  form.radius_across = 1. / across;
  form.radius_along = std::numeric_limits<double>::infinity();
  form.contact_modulus = loads::contact_modulus(material_of(solution, contact.source),
                                                material_of(solution, contact.target));
  if (along * form.length > 1e-9) {
    form.radius_along = 1. / along;
    form.ellipse =
        loads::hertz_ellipse(form.force, std::max(form.radius_across, 1. / along),
                             std::min(form.radius_across, 1. / along), form.contact_modulus);
    // Hertz's ellipse needs a profile that is a parabola as far as the contact reaches, and a
    // contact that ends before the surfaces do.
    const auto [lowest, highest] = extent_along(contact);
    const double half_length = form.half_length();
    const double over_all = curvature_along(solution, contact, z, half_length);
    if (std::abs(over_all / along - 1.) < parabolic && z - half_length > lowest &&
        z + half_length < highest)
      return form;
    form.radius_along = std::numeric_limits<double>::infinity();
    form.ellipse.reset();
  }
  form.line = loads::hertz_line(form.force / form.length, form.radius_across, form.contact_modulus);
  return form;
}

std::vector<ContactSection> contact_sections(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const std::vector<CellStress<3>>& cells) {
  const ContactFrame frame = contact_frame(contact);
  std::vector<ContactSection> sections;
  for (const Layer& layer : loaded_layers(contact, frame))
    if (layer.size() > 1) sections.push_back(section_of(layer, frame));
  add_shear(sections, solution.dof_handler->get_communicator(),
            shear_below(sections, frame, cells));
  return sections;
}

const ContactSection& middle_section(const fem::ContactResult<3>& contact,
                                     const std::vector<ContactSection>& sections) {
  const auto [lowest, highest] = extent_along(contact);
  const double middle = (lowest + highest) / 2.;
  if (sections.empty()) throw std::invalid_argument("a contact without load has no middle section");
  return *std::min_element(sections.begin(), sections.end(),
                           [&](const ContactSection& a, const ContactSection& b) {
                             return std::abs(a.z - middle) < std::abs(b.z - middle);
                           });
}

double common_length(const fem::ContactResult<3>& contact) {
  const auto [lowest, highest] = extent_along(contact);
  return highest - lowest;
}

LineLoad line_load(const fem::ContactResult<3>& contact,
                   const std::vector<ContactSection>& sections) {
  if (sections.empty()) return {0., 0.};
  const auto [lowest, highest] = extent_along(contact);
  const double near = 1e-6 * (highest - lowest);
  LineLoad load{middle_section(contact, sections).line_load, 0.};
  for (const ContactSection* end : {&sections.front(), &sections.back()})
    if (end->z < lowest + near || end->z > highest - near)
      load.end = std::max(load.end, end->line_load);
  return load;
}

}  // namespace geneva::post
