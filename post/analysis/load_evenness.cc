#include "post/analysis/load_evenness.h"

#include <algorithm>

#include "base/errors.h"
#include "post/analysis/results.h"

namespace geneva::post {

namespace {

/// Load up to a place: the line load is linear between the sections.
double load_up_to(const std::vector<ContactSection>& sections, const double z) {
  double load = 0.;
  for (std::size_t i = 1; i < sections.size() && sections[i - 1].z < z; ++i) {
    const ContactSection& from = sections[i - 1];
    const ContactSection& to = sections[i];
    const double step = std::min(z, to.z) - from.z;
    const double end = from.line_load + step / (to.z - from.z) * (to.line_load - from.line_load);
    load += step * (from.line_load + end) / 2.;
  }
  return load;
}

}  // namespace

loads::MaximumMean maximum_mean_load(const std::vector<ContactSection>& sections,
                                     const double length) {
  std::vector<double> places;
  for (const ContactSection& section : sections) places.push_back(section.z);
  return loads::maximum_mean(
      places, [&](const double z) { return load_up_to(sections, z); }, length);
}

loads::LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<3>& contact = solution.contacts[leading];
  const auto& sections = results.contacts[leading].sections;
  if (sections.empty()) throw base::InputError("the contact carries no load along its length");
  const ContactFrame& frame = results.contacts[leading].frame;
  const double length = common_length(contact, frame);
  const loads::MaximumMean maximum = maximum_mean_load(sections, loads::evenness_window * length);
  double force = 0.;
  for (const fem::ContactNode<3>& node : contact.nodes) force += node.pressure * node.tributary;
  std::vector<loads::LoadedPlace> places;
  for (const ContactSection& section : sections)
    places.push_back({section.z, section.line_load, section.peak_pressure});
  return {maximum.value,
          maximum.place,
          frame.parts() * force / length,
          contact.peak_pressure,
          middle_section(contact, frame, sections).peak_pressure,
          !solution.edge || solution.edge->is_bounded,
          places};
}

}  // namespace geneva::post
