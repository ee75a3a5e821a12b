#include "model/input/optimisation_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"

namespace geneva::model {

namespace {

using base::Dimension;
using Goal = OptimisationCase::Goal;

constexpr const char* pressure_word = "peak contact pressure";
constexpr const char* cycle_word = "peak contact pressure of the cycle";
constexpr const char* mass_word = "mass of the wheel";
constexpr const char* bottom_word = "stress at the slot bottom";

Goal goal_of(const std::string& word) {
  if (word == mass_word) return Goal::mass;
  if (word == bottom_word) return Goal::slot_bottom;
  return word == pressure_word ? Goal::pressure : Goal::pressure_of_cycle;
}

/// "Wheel diameter: 50 mm .. 200 mm"
FreeDimension read_free(const CaseSection& section, const std::string& text) {
  const std::string wanted =
      "'NAME: LEAST .. GREATEST' is wanted, for example 'Wheel diameter: 80 mm .. 160 mm'";
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    section.refuse("Free", fmt::format("{}: {}", base::in_quotes(trimmed(text)), wanted));
  Variation range;
  try {
    range = read_variation("Mechanism/" + trimmed(text.substr(0, colon)) + " = " +
                           text.substr(colon + 1) + ", 2");
  } catch (const base::InputError&) {
    section.refuse("Free", fmt::format("{}: {}", base::in_quotes(trimmed(text)), wanted));
  }
  FreeDimension free{range.section, range.name, 0., 0., ""};
  const auto number = [&](const std::string& value) {
    std::size_t end = 0;
    const double result = std::stod(value, &end);
    free.unit = trimmed(value.substr(end));
    return result;
  };
  free.lower = number(range.values.front());
  free.upper = number(range.values.back());
  if (free.lower >= free.upper)
    section.refuse("Free",
                   fmt::format("{}: the least value comes first", base::in_quotes(trimmed(text))));
  return free;
}

}  // namespace

std::string FreeDimension::text(const double value) const {
  return trimmed(fmt::format("{:.9g} {}", value, unit));
}

std::vector<Parameter> optimisation_parameters() {
  const SectionPath section{names::optimisation};
  const QuantityRule stress = positive(Dimension::stress, {""});
  return {
      {section, "Free", "", TextRule{"names with their bounds, separated by semicolons"},
       "Dimensions of the subsection Mechanism that 'geneva optimise' may choose, each with its "
       "bounds: 'Wheel diameter: 80 mm .. 160 mm; Pin diameter: 8 mm .. 20 mm'."},
      {section, "Minimise", cycle_word,
       ChoiceRule{{cycle_word, pressure_word, mass_word, bottom_word}},
       "What is to be least. 'peak contact pressure': Hertz's at the driver angle that is "
       "analysed. "
       "'stress at the slot bottom': the wheel's maximum tensile stress away from the contact, by "
       "finite elements."},
      {section, "Largest contact pressure", "", stress,
       "Limit of Hertz's pressure over the cycle."},
      {section, "Largest mass", "", positive(Dimension::mass, {""}),
       "Limit of the drawn wheel's mass."},
      {section, "Largest stress at the slot bottom", "", stress,
       "Limit of the wheel's maximum tensile stress away from the contact, by finite elements."},
      {section, "Largest stress at the pin root", "", stress,
       "Limit of the bending stress where the pin is held, by beam theory, over the cycle."}};
}

std::optional<OptimisationCase> read_optimisation(const CaseValues& values) {
  const CaseSection section(values, {names::optimisation});
  const std::string free = section.text("Free");
  if (free.empty()) {
    for (const Parameter& parameter : optimisation_parameters())
      if (section.is_changed(parameter.name))
        section.refuse(parameter.name, "this has an effect with 'Free' only, which is missing");
    return std::nullopt;
  }
  OptimisationCase result{{},
                          goal_of(section.text("Minimise")),
                          section.optional_value("Largest contact pressure"),
                          section.optional_value("Largest mass"),
                          section.optional_value("Largest stress at the slot bottom"),
                          section.optional_value("Largest stress at the pin root")};
  std::size_t begin = 0;
  while (begin <= free.size()) {
    const std::size_t end = std::min(free.find(';', begin), free.size());
    if (const std::string part = trimmed(free.substr(begin, end - begin)); !part.empty())
      result.free.push_back(read_free(section, part));
    begin = end + 1;
  }
  constexpr std::size_t most = 6;
  if (result.free.size() > most)
    section.refuse(
        "Free", fmt::format("{} dimensions are free; at most {} can be", result.free.size(), most));
  return result;
}

}  // namespace geneva::model
