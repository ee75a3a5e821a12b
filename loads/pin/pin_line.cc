#include "loads/pin/pin_line.h"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/pin/coupled_sections.h"
#include "loads/pin/held_beam.h"
#include "loads/pin/section_search.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

using Vector = Eigen::VectorXd;

/// Less than that from an end of the wall, over its half-length, is at it.
constexpr double rounding_of_ends = 1e-9;

/// The vertex of a parabola through three places around the greatest load.
void find_peak(PinLineContact& contact) {
  const auto& all = contact.sections;
  const auto top = std::max_element(
      all.begin(), all.end(),
      [](const PinSection& a, const PinSection& b) { return a.line_load < b.line_load; });
  double load = top->line_load;
  contact.peak_place = top->place;
  if (top != all.begin() && top + 1 != all.end()) {
    const double before = top->place - (top - 1)->place;
    const double after = (top + 1)->place - top->place;
    const double rise_before = (load - (top - 1)->line_load) / before;
    const double rise_after = ((top + 1)->line_load - load) / after;
    const double curve = (rise_after - rise_before) / (before + after);
    const double slope = (rise_before * after + rise_after * before) / (before + after);
    if (curve < 0.) {
      load -= slope * slope / (4. * curve);
      contact.peak_place -= slope / (2. * curve);
    }
  }
  contact.peak_line_load = load;
}

/// Where the load begins, seen from the first of the sections: on a smooth pin it rises from 0 in a
/// straight line, as Hertz's does.
template <typename Iterator>
double end_of_contact(const Iterator first, const Iterator last) {
  const auto loaded =
      std::find_if(first, last, [](const PinSection& section) { return section.line_load > 0.; });
  const double outwards = first->place < (last - 1)->place ? -1. : 1.;
  const double reach = loaded->width / 2.;
  if (loaded == first || loaded + 1 == last || (loaded + 1)->line_load <= loaded->line_load)
    return loaded->place + outwards * reach;
  const double rise =
      ((loaded + 1)->line_load - loaded->line_load) / std::abs((loaded + 1)->place - loaded->place);
  return loaded->place + outwards * std::clamp(loaded->line_load / rise, 0., 2. * reach);
}

HertzLine line_contact(const PinLine& pin, const double line_load) {
  return hertz_line(line_load, pin.relative_radius, contact_modulus(pin.pin, pin.wheel));
}

/// Peak pressure of Hertz's ellipse over that of a line contact with the line load of its middle.
/// @param ratio half-width of the line contact over the half-length
double ellipse_over_line(const double ratio) {
  constexpr int steps = 8;
  constexpr double widest = 0.9;
  double factor = 1.;
  for (int i = 0; i < steps; ++i) {  // the ellipse is narrower by the factor
    const double k = std::min(ratio / factor, widest);
    const double modulus = std::sqrt(1. - k * k);
    factor = modulus /
             std::sqrt(boost::math::ellint_2(modulus) - k * k * boost::math::ellint_1(modulus));
  }
  return factor;
}

std::vector<PinSection>::const_iterator section_at(const PinLineContact& contact,
                                                   const double place) {
  return std::find_if(contact.sections.begin(), contact.sections.end(),
                      [&](const PinSection& section) {
                        return std::abs(place - section.place) <= section.width / 2. * (1. + 1e-9);
                      });
}

/// Of the two sections at a place on the edge between them.
double width_at(const PinLineContact& contact, const double place) {
  const auto section = section_at(contact, place);
  if (section == contact.sections.end()) return contact.sections.back().width;
  const bool has_next = section + 1 != contact.sections.end();
  return section->width + (has_next ? (section + 1)->width : 0.);
}

PinLineContact contact_of(const PinLine& pin, const CoupledSections& sections,
                          const SectionSearch& search) {
  PinLineContact contact;
  const HeldBeam beam(pin);
  const bool has_free_end = pin.hold == PinHold::one_end;
  const double observed = pin.clearance.upper_end - (has_free_end ? pin.clearance.lower_end : 0.);
  for (Eigen::Index i = 0; i < sections.size(); ++i) {
    const double place = sections.places()[i];
    const double width = sections.widths()[i];
    const double load = search.loads()[i];
    contact.sections.push_back({place, width, load, sections.half_width(i, load)});
    const double from_root = pin.clearance.upper_end - place;
    contact.root_moment += load * width * beam.moment(from_root);
    contact.deflection += load * width * beam.flexibility(observed, from_root);
    contact.slope += load * width * beam.turn(pin.clearance.upper_end, from_root);
  }
  contact.begin = end_of_contact(contact.sections.begin(), contact.sections.end());
  contact.end = end_of_contact(contact.sections.rbegin(), contact.sections.rend());
  contact.approach = search.approach();
  contact.root_stress =
      contact.root_moment * pin.radius * pin.pin.youngs_modulus / beam.bending_stiffness();
  find_peak(contact);
  contact.peak_pressure = peak_contact(pin, contact).peak_pressure;
  return contact;
}

/// Loads of other sections at places, by straight lines; beyond them that of the last one.
Vector loads_at(const PinLineContact& known, const Vector& places) {
  Vector result(places.size());
  const auto& all = known.sections;
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const auto after = std::lower_bound(
        all.begin(), all.end(), places[i],
        [](const PinSection& section, const double place) { return section.place < place; });
    if (after == all.begin() || after == all.end()) {
      result[i] = after == all.end() ? all.back().line_load : after->line_load;
      continue;
    }
    const auto before = after - 1;
    const double share = (places[i] - before->place) / (after->place - before->place);
    result[i] = (1. - share) * before->line_load + share * after->line_load;
  }
  return result;
}

PinLineContact solved(const PinLine& pin, const double force, const SectionEdges& edges,
                      const PinLineContact* const known) {
  CoupledSections sections(pin, edges);
  const Vector start =
      known ? loads_at(*known, sections.places()) : Vector::Ones(sections.size()).eval();
  SectionSearch search(sections, force, start);
  search.run();
  return contact_of(pin, sections, search);
}

/// Even sections, or thinner ones towards an end of the wall that the contact reaches, and towards
/// both ends of a logarithmic profile, which falls within the contact's width.
SectionEdges edges_between(const PinLine& pin, const double begin, const double end, const int n) {
  const double wall_half = pin.clearance.wall_half;
  const double rounding = rounding_of_ends * wall_half;
  const bool is_logarithmic = std::holds_alternative<LogarithmicProfile>(pin.clearance.profile);
  const bool is_lower = is_logarithmic || begin < -wall_half + rounding;
  const bool is_upper = is_logarithmic || end > wall_half - rounding;
  const auto place = [&](const double x) {  // x from 0 to 1
    if (is_lower && is_upper) return 0.5 - 0.5 * std::cos(pi * x);
    if (is_lower) return 1. - std::cos(pi / 2. * x);
    return is_upper ? std::sin(pi / 2. * x) : x;
  };
  SectionEdges edges;
  for (int i = 0; i <= n; ++i)
    edges.push_back(begin + (end - begin) * place(static_cast<double>(i) / n));
  return edges;
}

/// Even ones.
SectionEdges edges_on_whole_wall(const double wall_half, const int n) {
  SectionEdges edges;
  for (int i = 0; i <= n; ++i) edges.push_back(wall_half * (2. * static_cast<double>(i) / n - 1.));
  return edges;
}

/// Where sections are to be: the contact of others and a section beyond, within the wall.
std::pair<double, double> window(const PinLineContact& contact, const double wall_half) {
  return {std::max(contact.begin - contact.sections.front().width, -wall_half),
          std::min(contact.end + contact.sections.back().width, wall_half)};
}

bool begins_at_end(const PinLineContact& contact, const double wall_half) {
  return contact.begin <= -wall_half * (1. - rounding_of_ends);
}
bool ends_at_end(const PinLineContact& contact, const double wall_half) {
  return contact.end >= wall_half * (1. - rounding_of_ends);
}

double change(const double value, const double before) {
  return before == 0. ? 0. : std::abs(value / before - 1.);
}

/// Sets the error by what half as many sections found. A contact that its sections cut off has not
/// settled, nor has one whose ends still move.
bool has_settled(PinLineContact& contact, const PinLineContact& coarse, const double wall_half,
                 const double accuracy) {
  constexpr double most_moved = 0.02;  // of the length
  contact.error = std::max(change(contact.peak_pressure, coarse.peak_pressure),
                           change(contact.root_moment, coarse.root_moment));
  const double moved = std::abs(contact.begin - coarse.begin) + std::abs(contact.end - coarse.end);
  const bool is_cut_off =
      (contact.sections.front().line_load > 0. && !begins_at_end(contact, wall_half)) ||
      (contact.sections.back().line_load > 0. && !ends_at_end(contact, wall_half));
  return contact.error <= accuracy && !is_cut_off &&
         moved <= most_moved * (contact.end - contact.begin);
}

/// Whether a contact reaches where the wall begins to be broken, or its end.
struct Reached {
  bool lower;
  bool upper;
};

Reached reached_edges(const PinLine& pin, const PinLineContact& contact) {
  const double flank = pin.clearance.wall_half - pin.clearance.wall_edge.size;
  return {contact.begin<width_at(contact, contact.begin) - flank, contact.end> flank -
          width_at(contact, contact.end)};
}

/// Relative radius of the line contact that has the peak's load and half-width [m].
double edge_radius(const PinLine& pin, const PinLineContact& contact) {
  const double b = contact.edge_half_width;
  return b * b * pi * contact_modulus(pin.pin, pin.wheel) / (4. * contact.peak_line_load);
}

/// From the middle of the contact to an end of it: sections that become thinner towards the edge
/// where they have the size of its round, over which they go on; even ones to an end without.
/// @param end where the edge begins, or the contact ends [m], from the middle, > 0
/// @param fine at the edge [m]
std::vector<double> half_of_edges(const double end, const double even, const bool is_edge,
                                  const double fine, const double wall) {
  constexpr double growth = 1.25;
  constexpr int on_round = 16;
  std::vector<double> places{end};
  double size = is_edge ? fine : even;
  while (places.back() > size) {
    places.push_back(places.back() - size);
    size = std::min(growth * size, even);
  }
  std::reverse(places.begin(), places.end());
  if (places.size() > 1) places.front() = 0.;
  for (int i = 1; is_edge && i <= on_round && end + i * fine < wall; ++i)
    places.push_back(end + i * fine);
  return places;
}

SectionEdges edges_on_rounds(const PinLine& pin, const PinLineContact& known, const double fine) {
  constexpr double even_sections = 24.;
  const double wall = pin.clearance.wall_half;
  const double flank = wall - pin.clearance.wall_edge.size;
  const Reached reached = reached_edges(pin, known);
  const auto [begin, end] = window(known, wall);
  const double low = reached.lower ? -flank : begin;
  const double high = reached.upper ? flank : end;
  const double middle = (low + high) / 2.;
  const double even = (high - low) / even_sections;
  const auto half = [&](const bool is_edge, const double wall_end) {
    return half_of_edges((high - low) / 2., even, is_edge, fine, wall_end);
  };
  SectionEdges edges;
  for (const double place : half(reached.lower, wall + middle)) edges.push_back(middle - place);
  std::reverse(edges.begin(), edges.end());
  const std::vector<double> upper = half(reached.upper, wall - middle);
  for (std::size_t i = 1; i < upper.size(); ++i) edges.push_back(middle + upper[i]);
  return edges;
}

/// With the pressure 2 q/(pi b) of the sections' own half-widths.
PinLineContact solved_on_rounds(const PinLine& pin, const double force, const SectionEdges& edges,
                                const PinLineContact& known) {
  CoupledSections sections(pin, edges);
  sections.widen_by_bending();
  SectionSearch search(sections, force, loads_at(known, sections.places()));
  search.run();
  PinLineContact contact = contact_of(pin, sections, search);
  const auto pressure = [](const PinSection& section) {
    return section.line_load / section.half_width;
  };
  const auto top = std::max_element(
      contact.sections.begin(), contact.sections.end(),
      [&](const PinSection& a, const PinSection& b) { return pressure(a) < pressure(b); });
  contact.peak_place = top->place;
  contact.peak_line_load = top->line_load;
  contact.edge_half_width = top->half_width;
  contact.peak_pressure = peak_contact(pin, contact).peak_pressure;
  return contact;
}

void require(const PinLine& pin, const double force) {
  require_positive_length("pin radius", pin.radius);
  require_positive_length("relative radius", pin.relative_radius);
  require_positive_length("wheel thickness", 2. * pin.clearance.wall_half);
  require_positive("pin force", force, "N");
}

}  // namespace

HertzLine peak_contact(const PinLine& pin, const PinLineContact& contact) {
  if (const double b = contact.edge_half_width; b > 0.)
    return hertz_line(contact.peak_line_load, edge_radius(pin, contact),
                      contact_modulus(pin.pin, pin.wheel));
  HertzLine hertz = line_contact(pin, contact.peak_line_load);
  const double factor = ellipse_over_line(2. * hertz.half_width / (contact.end - contact.begin));
  hertz.peak_pressure *= factor;
  hertz.half_width /= factor;
  hertz.max_shear *= factor;
  hertz.max_shear_depth /= factor;
  return hertz;
}

double line_load_at(const PinLineContact& contact, const double place) {
  const auto section = section_at(contact, place);
  if (section == contact.sections.end()) return 0.;
  const bool is_last = section + 1 == contact.sections.end();
  const bool is_first = section == contact.sections.begin();
  if (place >= section->place ? is_last : is_first) return section->line_load;
  const auto other = place >= section->place ? section + 1 : section - 1;
  const double share = (place - section->place) / (other->place - section->place);
  return section->line_load + share * (other->line_load - section->line_load);
}

bool is_near_end(const PinLine& pin, const PinLineContact& contact) {
  const PinClearance& ends = pin.clearance;
  return std::min(ends.upper_end - contact.end, contact.begin - ends.lower_end) < pin.radius;
}

bool is_beam(const PinLine& pin) {
  constexpr double nearest = 1.3;  // in diameters
  const PinClearance& ends = pin.clearance;
  const double gap = std::min(ends.upper_end - ends.wall_half, -ends.lower_end - ends.wall_half);
  return pin.hold == PinHold::one_end ||
         (pin.hold == PinHold::both_ends && gap >= 2. * nearest * pin.radius);
}

double expected_error(const PinLine& pin, const PinLineContact& contact) {
  constexpr double beside_finite_elements = 0.01;
  constexpr double at_rounded_edges = 0.05;
  if (contact.edge_half_width > 0.) return contact.error + at_rounded_edges;
  const double of_line = line_contact(pin, contact.peak_line_load).peak_pressure;
  return contact.error + (contact.peak_pressure / of_line - 1.) / 2. + beside_finite_elements;
}

PeakDoubt peak_doubt(const PinLine& pin, const PinLineContact& contact) {
  constexpr double widths_from_end = 8.;
  constexpr double most_error = 0.01;
  constexpr double most_error_on_rounds = 0.03;
  if (contact.edge_half_width > 0.)
    return contact.error > most_error_on_rounds ? PeakDoubt::not_settled : PeakDoubt::none;
  const Reached reached = reached_edges(pin, contact);
  if (reached.lower || reached.upper) return PeakDoubt::reaches_edge;
  const double b = peak_contact(pin, contact).half_width;
  if (const auto* const profile = std::get_if<LogarithmicProfile>(&pin.clearance.profile))
    if (std::abs(contact.peak_place) > profile->length / 2. - widths_from_end * b)
      return PeakDoubt::at_profile_end;
  return contact.error > most_error ? PeakDoubt::not_settled : PeakDoubt::none;
}

PinLineContact pin_line_contact(const PinLine& pin, const double force, const double accuracy) {
  constexpr int on_whole_wall = 16;
  constexpr int fewest = 12;
  constexpr int most = 192;
  constexpr int most_at_edges = 48;  // where the peak grows with them for ever
  require(pin, force);
  const double wall_half = pin.clearance.wall_half;
  PinLineContact coarse =
      solved(pin, force, edges_on_whole_wall(wall_half, on_whole_wall), nullptr);
  for (int n = fewest; n <= most; n *= 2) {
    const auto [begin, end] = window(coarse, wall_half);
    PinLineContact contact = solved(pin, force, edges_between(pin, begin, end, n), &coarse);
    const bool is_settled = n > fewest && has_settled(contact, coarse, wall_half, accuracy);
    coarse = std::move(contact);
    const Reached reached = reached_edges(pin, coarse);
    if (is_settled || (n >= most_at_edges && (reached.lower || reached.upper))) break;
  }
  return coarse;
}

PinLineContact resolved_edges(const PinLine& pin, const double force, PinLineContact contact) {
  const EdgeBreak& edge = pin.clearance.wall_edge;
  const Reached reached = reached_edges(pin, contact);
  if (edge.kind != EdgeBreak::Kind::rounded || !(reached.lower || reached.upper)) return contact;
  const double even = force / (2. * pin.clearance.wall_half);
  const double c = std::sqrt(2. * edge.size * even / (pi * contact_modulus(pin.pin, pin.wheel)));
  const PinLineContact coarse =
      solved_on_rounds(pin, force, edges_on_rounds(pin, contact, c / 2.), contact);
  PinLineContact fine = solved_on_rounds(pin, force, edges_on_rounds(pin, contact, c / 4.), coarse);
  fine.error = std::max(change(fine.peak_pressure, coarse.peak_pressure),
                        change(fine.root_moment, coarse.root_moment));
  return fine;
}

}  // namespace geneva::loads
