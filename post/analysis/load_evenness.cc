#include "post/analysis/load_evenness.h"

#include <algorithm>

#include "base/errors.h"
#include "post/analysis/results.h"

namespace geneva::post {

namespace {

/// Part of the length over which the line load is averaged.
constexpr double window = 0.05;

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

MaximumMean maximum_mean_load(const std::vector<ContactSection>& sections, const double length) {
  MaximumMean maximum{0., 0.};
  // a mean is greatest around a peak, or where the window begins or ends at an end of the load
  for (const ContactSection& section : sections)
    for (const double start : {section.z, section.z - length / 2., section.z - length}) {
      const double mean =
          (load_up_to(sections, start + length) - load_up_to(sections, start)) / length;
      if (mean > maximum.value) maximum = {mean, start + length / 2.};
    }
  return maximum;
}

LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<3>& contact = solution.contacts[leading];
  const auto& sections = results.contacts[leading].sections;
  if (sections.empty()) throw base::InputError("the contact carries no load along its length");
  const ContactFrame& frame = results.contacts[leading].frame;
  const double length = common_length(contact, frame);
  const MaximumMean maximum = maximum_mean_load(sections, window * length);
  double force = 0.;
  for (const fem::ContactNode<3>& node : contact.nodes) force += node.pressure * node.tributary;
  return {maximum.value,
          maximum.place,
          frame.parts() * force / length,
          contact.peak_pressure,
          middle_section(contact, frame, sections).peak_pressure,
          !solution.edge || solution.edge->is_bounded,
          sections};
}

}  // namespace geneva::post
