#include "loads/motion/long_dwell_geneva.h"

#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

class LongDwell : public MechanismType {
 public:
  LongDwell(const double spacing, const loads::SprocketLine line)
      : spacing_(spacing), line_(line) {}

  [[nodiscard]] loads::Mechanism mechanism(const Sizes& sizes) const override {
    return loads::long_dwell_geneva(sizes.stations, crank_radius(sizes), spacing_, line_);
  }
  [[nodiscard]] std::vector<std::pair<std::string, double>> lengths() const override {
    return {{"sprocket spacing", spacing_}};
  }

 private:
  double spacing_;  ///< of the sprockets' axes [m]
  loads::SprocketLine line_;
};

constexpr const char* along = "along line of centres";
constexpr const char* across = "across line of centres";

}  // namespace

MechanismKind long_dwell_kind() {
  const SectionPath section{names::mechanism};
  const std::string only = " Only with Type = long dwell.";
  MechanismKind kind;
  kind.name = "long dwell";
  kind.help = "a chain around two sprockets carries the pin.";
  kind.sizes = {"Crank radius"};
  kind.unused = lengths_of_drawings();
  kind.section = section;
  kind.parameters = {
      {section, "Sprocket spacing", "0 m", quantity(base::Dimension::length, zero_or_greater()),
       "Distance between the axes of the two sprockets, whose pitch radius is the crank radius." +
           only},
      {section, "Sprocket line", along, ChoiceRule{{along, across}},
       "'along line of centres': the second sprocket lies behind the first, seen from the wheel; "
       "'across line of centres': they lie side by side, and the pin passes the wheel on the "
       "straight stretch." +
           only}};
  kind.read = [section](const CaseValues& values, const MechanismType::Sizes&) {
    return std::make_shared<LongDwell>(values.value(section, "Sprocket spacing").value(),
                                       values.text(section, "Sprocket line") == across
                                           ? loads::SprocketLine::across_line_of_centres
                                           : loads::SprocketLine::along_line_of_centres);
  };
  return kind;
}

}  // namespace geneva::model
