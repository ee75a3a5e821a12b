#include <fmt/format.h>

#include <cmath>

#include "loads/drawing/linkage_drawing.h"
#include "loads/motion/four_bar_geneva.h"
#include "loads/pi.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

class FourBar : public MechanismType {
 public:
  FourBar(const loads::FourBar& linkage, const loads::Assembly assembly,
          const loads::WheelPlace& place)
      : linkage_(linkage), assembly_(assembly), place_(place) {}

  [[nodiscard]] loads::Mechanism mechanism(const Sizes& sizes) const override {
    return geneva(sizes).mechanism;
  }
  [[nodiscard]] std::vector<std::string> notices(const Sizes& sizes,
                                                 const base::UnitSystem units) const override {
    const auto length = base::output_unit(units, base::Dimension::length);
    const loads::FourBarGeneva found = geneva(sizes);
    return {fmt::format(
        "the wheel's axis is {:.6g} {} from the crank's; driver angle 0 is a crank angle of {:.6g} "
        "deg from the frame",
        found.centre_distance * length.factor, length.name,
        std::remainder(found.crank_angle, 2. * loads::pi) * 180. / loads::pi)};
  }
  [[nodiscard]] std::function<loads::Polyline(double)> linkage(const Sizes& sizes) const override {
    return loads::LinkageDrawing(linkage_, assembly_, place_.direction, geneva(sizes));
  }

 private:
  [[nodiscard]] loads::FourBarGeneva geneva(const Sizes& sizes) const {
    return loads::four_bar_geneva(sizes.stations, linkage_, assembly_, place_);
  }

  loads::FourBar linkage_;
  loads::Assembly assembly_;
  loads::WheelPlace place_;
};

std::vector<Parameter> linkage_parameters(const SectionPath& section) {
  const QuantityRule length = positive(base::Dimension::length, {""});
  return {
      {section, "Crank", "", length, "Crank AB of the linkage. Only with Type = four-bar."},
      {section, "Coupler", "", length, "Coupler BC."},
      {section, "Rocker", "", length, "Rocker CD."},
      {section, "Frame", "", length, "Distance AD of the pivots of crank and rocker."},
      {section, "Coupler point distance", "0 m",
       quantity(base::Dimension::length, zero_or_greater()),
       "Distance BP of the coupler point, which is the pin, from the end of the crank."},
      {section, "Coupler point angle", "0 deg", quantity(base::Dimension::angle),
       "Angle from BC to BP, counter-clockwise."},
      {section, "Assembly", "open", ChoiceRule{{"open", "crossed"}},
       "'open': C lies to the left of the line from B to D; 'crossed': to its right. A "
       "parallelogram "
       "stays one if open."},
      {section, "Wheel direction", "0 deg", quantity(base::Dimension::angle),
       "Direction from the crank's axis to the wheel's axis, from the line AD, counter-clockwise. "
       "The distance is the centre distance; without it, it follows from the tangency of path and "
       "slot at entry and exit."}};
}

std::shared_ptr<const MechanismType> read_four_bar(const CaseValues& values,
                                                   const MechanismType::Sizes& sizes) {
  const CaseSection section(values, {names::mechanism, names::linkage});
  const loads::FourBar linkage{{0., 0.},
                               {section.value("Frame"), 0.},
                               section.value("Crank"),
                               section.value("Coupler"),
                               section.value("Rocker"),
                               section.value("Coupler point distance"),
                               section.value("Coupler point angle")};
  const loads::Assembly assembly =
      section.text("Assembly") == "open" ? loads::Assembly::open : loads::Assembly::crossed;
  return std::make_shared<FourBar>(
      linkage, assembly,
      loads::WheelPlace{section.value("Wheel direction"), sizes.centre_distance});
}

}  // namespace

MechanismKind four_bar_kind() {
  MechanismKind kind;
  kind.name = "four-bar";
  kind.help = "a point of a linkage's coupler is the pin (subsection Linkage).";
  kind.more_sizes = {"Centre distance"};
  kind.unused = lengths_of_drawings();
  kind.section = {names::mechanism, names::linkage};
  kind.parameters = linkage_parameters(kind.section);
  kind.needed = {"Crank", "Coupler", "Rocker", "Frame"};
  kind.read = read_four_bar;
  return kind;
}

}  // namespace geneva::model
