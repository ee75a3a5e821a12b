#include "loads/pin/load_evenness.h"

#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "loads/pin/maximum_mean.h"

namespace geneva::loads {

namespace {

/// Between which places a section lies.
double lower_edge(const PinSection& section) { return section.place - section.width / 2.; }
double upper_edge(const PinSection& section) { return section.place + section.width / 2.; }

double load_below(const std::vector<PinSection>& sections, const double z) {
  double load = 0.;
  for (const PinSection& section : sections)
    load += section.line_load * std::clamp(z - lower_edge(section), 0., section.width);
  return load;
}

}  // namespace

LoadEvenness load_evenness(const PinLine& pin, const PinLineContact& contact) {
  const double length = 2. * pin.clearance.wall_half;
  const double modulus = contact_modulus(pin.pin, pin.wheel);
  const auto pressure = [&](const double line_load) {
    return std::sqrt(line_load * modulus / (pi * pin.relative_radius));
  };
  std::vector<double> edges{lower_edge(contact.sections.front())};
  double force = 0.;
  LoadEvenness result{};
  for (const PinSection& section : contact.sections) {
    edges.push_back(upper_edge(section));
    force += section.line_load * section.width;
    result.sections.push_back({section.place, section.line_load, pressure(section.line_load)});
  }
  const MaximumMean maximum = maximum_mean(
      edges, [&](const double z) { return load_below(contact.sections, z); },
      evenness_window * length);
  result.maximum = maximum.value;
  result.place = maximum.place;
  result.even = force / length;
  result.peak_pressure = contact.peak_pressure;
  result.middle_pressure = pressure(line_load_at(contact, 0.));
  result.is_bounded = peak_doubt(pin, contact) != PeakDoubt::reaches_edge;
  return result;
}

}  // namespace geneva::loads
