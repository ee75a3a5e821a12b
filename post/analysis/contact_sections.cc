#include "post/analysis/contact_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/errors.h"
#include "fem/contact/peak_in_plane.h"
#include "fem/discretisation/gather.h"

namespace geneva::post {

using dealii::Tensor;

namespace {

using Node = fem::ContactNode<3>;

/// Nodes of one layer, in their order across the contact.
using Layer = std::vector<const Node*>;

/// Layers with a node in contact, by ascending z.
std::vector<Layer> loaded_layers(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
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
                                return std::none_of(layer.begin(), layer.end(), [](const Node* n) {
                                  return is_closed(n->status);
                                });
                              }),
               layers.end());
  for (Layer& layer : layers)
    std::sort(layer.begin(), layer.end(), [&](const Node* a, const Node* b) {
      return frame.distance_across(place_of(*a)) < frame.distance_across(place_of(*b));
    });
  return layers;
}

/// The top of the pressure across a layer, freed from where the nodes lie as that of a line
/// contact.
double peak_across(const Layer& layer, const ContactFrame& frame) {
  std::vector<fem::ContactNode<2>> nodes(layer.size());
  for (std::size_t i = 0; i < layer.size(); ++i) {
    nodes[i].arc_length = frame.distance_across(place_of(*layer[i]));
    nodes[i].pressure = layer[i]->pressure;
    nodes[i].status = layer[i]->status;
    nodes[i].tributary = layer[i]->tributary;
  }
  const fem::FittedPeak top = fem::fitted_peak(nodes);
  return top.pressure * (1. + top.averaging);
}

/// Integrals of the pressure across a layer by the trapezoidal rule, exact for linear pressure.
ContactSection section_of(const Layer& layer, const ContactFrame& frame) {
  ContactSection section{layer.front()->position[2], 0., peak_across(layer, frame), 0., 0., 0.};
  double first = 0.;
  double second = 0.;
  for (std::size_t i = 0; i < layer.size(); ++i) {
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

/// The maximum shear in this rank's cells below a section, and its depth.
using Shear = std::array<double, 2>;
using ShearBySection = std::vector<Shear>;

/// A cell counts for every section that passes through it.
ShearBySection shear_below(const std::vector<ContactSection>& sections, const ContactFrame& frame,
                           const std::vector<CellStress<3>>& cells) {
  ShearBySection maximum(sections.size(), Shear{0., 0.});
  double widest = 0.;
  for (const ContactSection& section : sections) widest = std::max(widest, section.half_width);
  for (const CellStress<3>& cell : cells) {
    const double depth = frame.depth(cell.centre);
    if (depth > 3. * widest || std::abs(frame.distance_across(cell.centre)) > 2. * widest) continue;
    const double reach = 0.5 * cell.height * (1. + 1e-9);
    const Shear entry{max_shear(principal_stresses(cell.stress)), depth};
    const auto first = std::lower_bound(
        sections.begin(), sections.end(), cell.centre[2] - reach,
        [](const ContactSection& section, const double z) { return section.z < z; });
    for (auto section = first; section != sections.end() && section->z <= cell.centre[2] + reach;
         ++section) {
      auto& found = maximum[static_cast<std::size_t>(section - sections.begin())];
      found = std::max(found, entry);
    }
  }
  return maximum;
}

void add_shear(std::vector<ContactSection>& sections, const MPI_Comm communicator,
               const ShearBySection& local) {
  const ShearBySection all = fem::gathered(communicator, local);
  for (std::size_t i = 0; i < all.size(); ++i) {
    ContactSection& section = sections[i % sections.size()];
    if (all[i][0] > section.max_shear) {
      section.max_shear = all[i][0];
      section.max_shear_depth = all[i][1];
    }
  }
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

/// Lagrange's basis polynomials of places at another.
std::vector<double> lagrange_weights(const std::vector<double>& places, const double z) {
  std::vector<double> weights(places.size(), 1.);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < places.size(); ++j)
      if (j != i) weights[i] *= (z - places[j]) / (places[i] - places[j]);
  return weights;
}

/// Between sections [first, last]. In an elliptical contact the line load and the squares of the
/// other figures are parabolas of z: those are interpolated.
ContactSection interpolated(const ContactSection* const first, const ContactSection* const last,
                            const double z) {
  using Section = ContactSection;
  std::vector<double> places;
  for (const Section* section = first; section <= last; ++section) places.push_back(section->z);
  const std::vector<double> weights = lagrange_weights(places, z);
  const auto root_of_squares = [&](double Section::*const figure) {
    double sum = 0.;
    for (std::size_t i = 0; i < weights.size(); ++i)
      sum += weights[i] * std::pow(first[i].*figure, 2);
    return std::sqrt(std::max(0., sum));
  };
  double line_load = 0.;
  for (std::size_t i = 0; i < weights.size(); ++i) line_load += weights[i] * first[i].line_load;
  return {z,
          line_load,
          root_of_squares(&Section::peak_pressure),
          root_of_squares(&Section::half_width),
          root_of_squares(&Section::max_shear),
          root_of_squares(&Section::max_shear_depth)};
}

}  // namespace

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

std::size_t nodes_across_middle(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  const auto distance = [middle = (lowest + highest) / 2.](const Layer& layer) {
    return std::abs(layer.front()->position[2] - middle);
  };
  const std::vector<Layer> layers = loaded_layers(contact, frame);
  const auto nearest =
      std::min_element(layers.begin(), layers.end(),
                       [&](const Layer& a, const Layer& b) { return distance(a) < distance(b); });
  if (nearest == layers.end()) return 0;
  return static_cast<std::size_t>(std::count_if(
      nearest->begin(), nearest->end(), [](const Node* node) { return is_closed(node->status); }));
}

ShearBelow maximum_shear(const fem::Solution<3>& solution, const ContactFrame& frame,
                         const double half_width, const std::vector<CellStress<3>>& cells) {
  Shear maximum{};
  for (const CellStress<3>& cell : cells) {
    const double depth = frame.depth(cell.centre);
    const double aside =
        std::hypot(frame.distance_across(cell.centre), frame.distance_along(cell.centre));
    if (depth > 3. * half_width || aside > 2. * half_width) continue;
    maximum = std::max(maximum, Shear{max_shear(principal_stresses(cell.stress)), depth});
  }
  for (const Shear& of_rank : fem::gathered_one(solution.dof_handler->get_communicator(), maximum))
    maximum = std::max(maximum, of_rank);
  return {maximum[0], maximum[1]};
}

ContactSection middle_section(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                              const std::vector<ContactSection>& sections) {
  if (sections.empty()) throw base::InputError("a contact without load has no middle section");
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  const double middle = (lowest + highest) / 2.;
  const auto above =
      std::find_if(sections.begin(), sections.end(),
                   [&](const ContactSection& section) { return section.z >= middle; });
  if (above == sections.begin()) return sections.front();
  if (above == sections.end()) return sections.back();
  const bool has_two_each =
      std::distance(sections.begin(), above) >= 2 && sections.end() - above >= 2;
  const std::ptrdiff_t on_each_side = has_two_each ? 2 : 1;
  return interpolated(&*(above - on_each_side), &*(above + on_each_side - 1), middle);
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
