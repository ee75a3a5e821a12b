#include "model/input/optimisation_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "model/input/case_models.h"
#include "model/input/parameters.h"
#include "model/input/variation.h"

namespace geneva::model {

namespace {

using base::Dimension;
using Goal = OptimisationCase::Goal;

Goal goal_of(const std::string& word) {
  if (word == names::wheel_mass) return Goal::mass;
  if (word == names::slot_bottom) return Goal::slot_bottom;
  return word == names::peak_pressure ? Goal::pressure : Goal::pressure_of_cycle;
}

bool is_whole(const Variation& varied) {
  const std::vector<Parameter> all = mechanism_parameters();
  return std::any_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    const auto* const rule = std::get_if<QuantityRule>(&parameter.rule);
    return parameter.section == varied.section && parameter.name == varied.name &&
           rule != nullptr && rule->whole;
  });
}

/// "Wheel diameter: 50 mm .. 200 mm"
FreeDimension read_free(const CaseSection& section, const std::string& text) {
  const std::string wanted =
      "'NAME: LEAST .. GREATEST' is wanted, for example 'Wheel diameter: 80 mm .. 160 mm'";
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || text.find("..", colon) == std::string::npos)
    section.refuse("Free", fmt::format("{}: {}", base::in_quotes(trimmed(text)), wanted));
  Variation range;
  try {
    range = read_variation("Mechanism/" + trimmed(text.substr(0, colon)) + " = " +
                           text.substr(colon + 1) + ", 2");
  } catch (const base::InputError& error) {
    section.refuse("Free",
                   fmt::format("{}: {}; {}", base::in_quotes(trimmed(text)), wanted, error.what()));
  }
  if (is_whole(range))
    section.refuse("Free", fmt::format("{} is a whole number, and no dimension; vary it with "
                                       "'geneva sweep', or optimise a case for each",
                                       base::in_quotes(range.name)));
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

void add_free(const CaseSection& section, std::vector<FreeDimension>& all,
              const FreeDimension& free) {
  for (const FreeDimension& other : all)
    if (other.section == free.section && other.name == free.name)
      section.refuse("Free", fmt::format("{} stands there twice", base::in_quotes(free.name)));
  all.push_back(free);
}

/// Refuses what cannot be known of the mechanism.
void check_known(const CaseSection& section, const OptimisationCase& wanted,
                 const MechanismCase& mechanism) {
  const auto refuse_undrawn = [&](const char* const parameter, const bool is_wanted) {
    if (is_wanted && !mechanism.type->is_drawn())
      section.refuse(parameter,
                     "the wheel of this type of mechanism is not drawn, so that it has neither a "
                     "mass nor a slot bottom; external and internal ones are");
  };
  refuse_undrawn("Minimise", wanted.goal == Goal::mass || wanted.goal == Goal::slot_bottom);
  refuse_undrawn("Largest mass", wanted.largest_mass.has_value());
  refuse_undrawn("Least wall", wanted.least_wall.has_value());
  refuse_undrawn("Largest stress at the slot bottom", wanted.largest_slot_bottom.has_value());
  if (wanted.largest_root_stress && mechanism.pin_holding.hold == PinHolding::Hold::core)
    section.refuse("Largest stress at the pin root", "the pin is held at its core: it has no root");
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
      {section, "Minimise", names::peak_pressure_of_cycle,
       ChoiceRule{{names::peak_pressure_of_cycle, names::peak_pressure, names::wheel_mass,
                   names::slot_bottom}},
       "What is to be least. 'peak contact pressure': Hertz's at the driver angle that is "
       "analysed. "
       "'stress at the slot bottom': the wheel's maximum tensile stress away from the contact, by "
       "finite elements."},
      {section, "Largest contact pressure", "", stress,
       "Limit of Hertz's pressure over the cycle."},
      {section, "Largest mass", "", positive(Dimension::mass, {""}),
       "Limit of the drawn wheel's mass."},
      {section, "Least wall", "", positive(Dimension::length, {""}),
       "The least that is left of the drawn wheel between slots, locking arcs, bore and rim, the "
       "tip beside a slot's mouth among them. Left out: a tenth of the slot's width."},
      {section, "Largest stress at the slot bottom", "", stress,
       "Limit of the wheel's maximum tensile stress away from the contact, by finite elements."},
      {section, "Largest stress at the pin root", "", stress,
       "Limit of the bending stress where the pin is held, by beam theory, over the cycle."}};
}

std::optional<OptimisationCase> read_optimisation(const CaseValues& values,
                                                  const MechanismCase& mechanism) {
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
                          section.optional_value("Least wall"),
                          section.optional_value("Largest stress at the slot bottom"),
                          section.optional_value("Largest stress at the pin root")};
  std::size_t begin = 0;
  while (begin <= free.size()) {
    const std::size_t end = std::min(free.find(';', begin), free.size());
    if (const std::string part = trimmed(free.substr(begin, end - begin)); !part.empty())
      add_free(section, result.free, read_free(section, part));
    begin = end + 1;
  }
  constexpr std::size_t most = 6;
  if (result.free.size() > most)
    section.refuse(
        "Free", fmt::format("{} dimensions are free; at most {} can be", result.free.size(), most));
  check_known(section, result, mechanism);
  return result;
}

}  // namespace geneva::model
