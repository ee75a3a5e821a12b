#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "model/input/case_models.h"
#include "model/input/case_path.h"
#include "model/input/column_file.h"
#include "model/pin_in_space.h"

namespace geneva::model {

namespace {

using Hold = PinHolding::Hold;
using Profile = PinCase::Profile;

Hold read_hold(const CaseSection& section) {
  const std::string word = section.text("Held at");
  if (word == names::both_ends) return Hold::both_ends;
  return word == names::core ? Hold::core : Hold::one_end;
}

Profile read_profile(const CaseSection& section) {
  const std::string word = section.text("Profile");
  if (word == names::crown) return Profile::crown;
  if (word == names::table) return Profile::table;
  return word == names::logarithmic ? Profile::logarithmic : Profile::cylindrical;
}

/// A parameter that one word of another one needs and the others do not know.
void check_partner(const CaseSection& section, const char* parameter, const char* chooser,
                   const bool is_wanted, const bool is_needed, const std::string& words) {
  if (is_wanted && is_needed && !section.is_given(parameter))
    section.refuse_missing(parameter,
                           fmt::format("'{}' = '{}' needs it", chooser, section.text(chooser)));
  if (!is_wanted && section.is_changed(parameter))
    section.refuse(parameter, fmt::format("this has an effect with {} = {} only", chooser, words));
}

void check_profile(const CaseSection& section, const Profile profile) {
  check_partner(section, "Crown radius", "Profile", profile == Profile::crown, true, names::crown);
  check_partner(section, "Profile table", "Profile", profile == Profile::table, true, names::table);
  for (const char* name : {"Profile load", "Profile amplitude", "Profile length"})
    check_partner(section, name, "Profile", profile == Profile::logarithmic, false,
                  names::logarithmic);
  if (section.optional_value("Profile load") && section.is_given("Profile amplitude"))
    section.refuse("Profile amplitude", "the profile load gives it already: give one of the two");
}

loads::ProfileTable read_table(const CaseSection& section, const std::filesystem::path& directory) {
  auto [places, heights] =
      read_two_columns(file_in_directory(section, "Profile table", directory),
                       {{{"z", base::Dimension::length}, {"height", base::Dimension::length}}},
                       "z [mm], height [um]");
  for (double& height : heights) height = -height;
  loads::ProfileTable table{std::move(places), std::move(heights)};
  try {
    loads::check(table, 0.);
  } catch (const std::invalid_argument& error) {
    section.refuse("Profile table", error.what());
  }
  return table;
}

std::optional<std::pair<double, double>> read_load_range(const CaseSection& section) {
  const std::vector<double> range = section.values("Load range");
  if (range.empty()) return std::nullopt;
  if (range[1] <= 0.)
    section.refuse("Load range", "no pin force is in it: the second one is greater than 0");
  if (range[0] > range[1])
    section.refuse("Load range", "the least force comes first, then the greatest");
  return std::make_pair(range[0], range[1]);
}

loads::EdgeBreak read_edge(const CaseSection& section) {
  const std::string word = section.text("Slot edge");
  const bool is_broken = word != names::sharp;
  check_partner(section, "Slot edge size", "Slot edge", is_broken, true,
                fmt::format("{} or {}", names::chamfered, names::rounded));
  if (!is_broken) return {};
  return {
      word == names::rounded ? loads::EdgeBreak::Kind::rounded : loads::EdgeBreak::Kind::chamfered,
      section.value("Slot edge size")};
}

}  // namespace

PinHolding read_pin_holding(const CaseValues& values) {
  const CaseSection section(values, {names::mechanism, names::pin});
  const PinHolding holding{read_hold(section), section.optional_value("Root gap"),
                           section.optional_value("Bore diameter")};
  if (holding.bore_diameter) {
    const CaseSection mechanism(values, {names::mechanism});
    if (mechanism.text("Pin type") == names::roller)
      section.refuse(
          "Bore diameter",
          "a roller has 'Roller bore diameter': this is the bore of a pin that is fixed");
    if (holding.hold == Hold::core)
      section.refuse("Bore diameter",
                     "with Held at = core the bore is the core: give 'Pin core "
                     "radius', at which the pin is held");
    if (mechanism.optional_value("Pin core radius") &&
        CaseSection(values, {}).text("Dimension") == "3")
      section.refuse("Bore diameter",
                     "'Pin core radius' is for a pin that is held at its core: give "
                     "one of the two");
  }
  if (holding.hold == Hold::core && holding.root_gap)
    section.refuse("Root gap", "this has no effect with Held at = core: the pin has no root");
  return holding;
}

PinCase read_pin(const CaseValues& values, const Hold hold,
                 const std::filesystem::path& directory) {
  const CaseSection section(values, {names::mechanism, names::pin});
  PinCase pin{};
  pin.overhang = section.optional_value("Overhang");
  pin.length = section.optional_value("Length");
  if (pin.length && pin.overhang)
    section.refuse("Length", "the overhang gives it already: give one of the two");
  for (const char* name : {"Overhang", "Length", "End chamfer"})
    if (hold == Hold::both_ends && section.is_changed(name))
      section.refuse(name, "this has no effect with Held at = both ends: the pin has no free end");
  pin.end_chamfer = section.value("End chamfer");
  pin.profile = read_profile(section);
  check_profile(section, pin.profile);
  pin.crown_radius = section.optional_value("Crown radius").value_or(0.);
  pin.profile_load = section.optional_value("Profile load");
  pin.profile_amplitude = section.optional_value("Profile amplitude");
  pin.profile_length = section.optional_value("Profile length");
  if (pin.profile == Profile::table) pin.table = read_table(section, directory);
  pin.tilt = section.value("Tilt");
  pin.tilt_tolerance = section.value("Tilt tolerance");
  pin.load_range = read_load_range(section);
  pin.slot_edge = read_edge(section);
  return pin;
}

void check_no_pin(const CaseValues& values) {
  static const std::set<std::string> plane_parameters{"Held at", "Root gap", "Bore diameter"};
  const CaseSection section(values, {names::mechanism, names::pin});
  for (const Parameter& parameter : mechanism_parameters())
    if (parameter.section == SectionPath{names::mechanism, names::pin} &&
        plane_parameters.count(parameter.name) == 0 && section.is_changed(parameter.name))
      section.refuse(parameter.name, "this has an effect with Dimension = 3 only");
}

void check_pin(const CaseValues& values, const MechanismCase& given, const MechanismSizes& sizes,
               const std::optional<double> slot_width) {
  const CaseSection section(values, {names::mechanism, names::pin});
  const PinCase& pin = *given.space;
  const PinLengths lengths = pin_lengths(given, sizes);
  const auto mm = [](const double length) { return 1e3 * length; };
  if (pin.length && lengths.overhang < 0.)
    section.refuse("Length",
                   fmt::format("the pin ends within the slot: root gap {:.6g} mm and wheel "
                               "thickness {:.6g} mm make {:.6g} mm; make the pin longer",
                               mm(lengths.root_gap), mm(sizes.thickness),
                               mm(lengths.root_gap + sizes.thickness)));
  const double half = sizes.thickness / 2.;
  if (pin.slot_edge.size > half)
    section.refuse("Slot edge size", fmt::format("it is more than half of the wheel's thickness, "
                                                 "{:.6g} mm: nothing is left of the slot's wall",
                                                 mm(half)));
  if (pin.profile == Profile::crown) {
    const double reach = half + std::max(lengths.overhang, lengths.root_gap);
    if (pin.crown_radius < reach)
      section.refuse("Crown radius",
                     fmt::format("it must be at least the {:.6g} mm from the middle of the wheel "
                                 "to the pin's end",
                                 mm(reach)));
  }
  if (!slot_width) return;
  constexpr double rounding = 1e-12;
  const double difference = *slot_width - sizes.pin_diameter;
  const double room = std::abs(difference) < rounding * sizes.pin_diameter ? 0. : difference;
  const double lean = std::tan(std::abs(pin.tilt) + pin.tilt_tolerance) * sizes.thickness;
  const char* const responsible = pin.tilt_tolerance == 0. ? "Tilt" : "Tilt tolerance";
  if (lean > room * (1. + 1e-9) && lean > 0.)
    section.refuse(responsible,
                   fmt::format("the pin touches the other wall: over the wheel's thickness "
                               "it leans by {:.6g} mm, the slot clearance is {:.6g} mm; "
                               "tilt it less or give a larger 'Slot clearance'",
                               mm(lean), mm(room)));
}

}  // namespace geneva::model
