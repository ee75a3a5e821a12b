#include <fmt/format.h>

#include <stdexcept>

#include "base/errors.h"
#include "model/input/case_models.h"

namespace geneva::model {

namespace {

double positive_length(const std::string& text) {
  const double length = base::parse_quantity(text, base::Dimension::length);
  if (length > 0.) return length;
  throw base::InputError(
      fmt::format("{}: the value must be greater than 0", base::in_quotes(text)));
}

/// "0.375 in x 5 in": the x stands alone, so that it is no part of a unit.
loads::ShaftSegment parse_segment(const std::string& text) {
  const std::string times = " x ";
  const std::size_t place = text.find(times);
  if (place == std::string::npos || text.find(times, place + 1) != std::string::npos)
    throw base::InputError(
        fmt::format("{}: a segment is a diameter, '{}' and a length, for example '0.375 in x 5 in'",
                    base::in_quotes(text), times));
  return {positive_length(text.substr(0, place)),
          positive_length(text.substr(place + times.size()))};
}

std::vector<loads::ShaftSegment> read_segments(const CaseSection& section) {
  std::vector<loads::ShaftSegment> segments;
  try {
    for (const std::string& part : split_list(section.text(names::shaft)))
      segments.push_back(parse_segment(part));
  } catch (const std::invalid_argument& error) {
    section.refuse(names::shaft, error.what());
  }
  return segments;
}

/// Refuses what says something about a shaft that there is not.
void check_without_shaft(const CaseSection& section) {
  const std::string reason = fmt::format("this has no effect without a '{}'", names::shaft);
  if (section.is_given("Amplitude radius")) section.refuse("Amplitude radius", reason);
  if (section.text("Add shaft inertia") == "true") section.refuse("Add shaft inertia", reason);
}

}  // namespace

DesignCase read_design(const CaseValues& values) {
  const CaseSection section(values, {names::mechanism, names::design});
  const CaseSection mechanism(values, {names::mechanism});
  DesignCase result{};
  result.given_lengths = section.text("Given lengths") == names::stay_as_given
                             ? loads::GivenLengths::stay
                             : loads::GivenLengths::scale;
  if (!section.is_given(names::shaft)) {
    check_without_shaft(section);
    return result;
  }
  result.shaft = loads::Shaft{read_segments(section), section.value("Shaft shear modulus"),
                              section.value("Shaft density")};
  result.adds_shaft_inertia = section.text("Add shaft inertia") == "true";
  result.amplitude_radius = section.optional_value("Amplitude radius");
  const auto load_diameter = mechanism.optional_value("Load diameter");
  if (!result.amplitude_radius && load_diameter) result.amplitude_radius = *load_diameter / 2.;
  return result;
}

}  // namespace geneva::model
