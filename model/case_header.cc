#include "model/case_header.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <map>
#include <string>
#include <variant>

#include "base/errors.h"
#include "model/block_dimensions.h"
#include "model/mechanism_state.h"
#include "model/pin_in_space.h"

namespace geneva::model {

namespace {

/// Values that the case leaves to a rule, by the names of their parameters.
class WorkedOut {
 public:
  explicit WorkedOut(const base::UnitSystem units) : units_(units) {}

  void add(const std::string& name, const double value,
           const base::Dimension dimension = base::Dimension::length) {
    const base::OutputUnit unit = base::output_unit(units_, dimension);
    values_[name] = fmt::format("{:.6g} {}", value * unit.factor, unit.name);
  }

  [[nodiscard]] const std::map<std::string, std::string>& values() const { return values_; }

 private:
  base::UnitSystem units_;
  std::map<std::string, std::string> values_;
};

void add_own(WorkedOut& found, const loads::GenevaDimensions& wheel) {
  found.add("Bore radius", wheel.bore_radius);
}

void add_own(WorkedOut& found, const loads::InternalDimensions& wheel) {
  found.add("Rim radius", wheel.rim_radius);
}

void add_wheel(WorkedOut& found, const DrawnWheel& drawn) {
  std::visit(
      [&](const auto& wheel) {
        found.add("Slot width", wheel.slot_width);
        found.add("Slot clearance", wheel.slot_width - wheel.pin_diameter);
        found.add("Slot depth", wheel.slot_depth);
        found.add("Locking radius", wheel.locking_radius);
        add_own(found, wheel);
      },
      drawn);
}

void add_block(WorkedOut& found, const loads::LocalDimensions& block) {
  found.add("Block width", block.width);
  found.add("Block depth", block.depth);
}

void add_pin(WorkedOut& found, const MechanismCase& mechanism, const MechanismSizes& sizes) {
  const PinLengths lengths = pin_lengths(mechanism, sizes);
  found.add("Pin/Root gap", lengths.root_gap);
  found.add("Pin/Overhang", lengths.overhang);
  if (mechanism.space->profile != PinCase::Profile::logarithmic) return;
  found.add("Pin/Profile length", mechanism.space->profile_length.value_or(sizes.thickness));
  if (mechanism.space->profile_amplitude) return;
  const double load = mechanism.space->profile_load.value_or(mechanism_state(mechanism).load.force);
  found.add("Pin/Profile load", load, base::Dimension::force);
}

/// Of a pin that is held at its core, as every pin in the plane.
void add_core(WorkedOut& found, const MechanismCase& mechanism, const MechanismSizes& sizes) {
  if (mechanism.space && mechanism.pin_holding.hold != PinHolding::Hold::core) return;
  found.add("Pin core radius", mechanism.bore_clearance
                                   ? stud_core_radius(mechanism)
                                   : block_dimensions(mechanism, sizes).pin_core_radius);
}

/// What cannot be worked out is left out: a case is not refused for it.
std::map<std::string, std::string> worked_out(const Case& given) {
  WorkedOut found(given.units);
  if (!given.mechanism) return {};
  const MechanismCase& mechanism = *given.mechanism;
  try {
    const MechanismDynamics dynamics = mechanism_dynamics(mechanism);
    found.add("Pin diameter", dynamics.sizes.pin_diameter);
    found.add("Wheel thickness", dynamics.sizes.thickness);
    add_core(found, mechanism, dynamics.sizes);
    if (mechanism.is_local) add_block(found, block_dimensions(mechanism, dynamics.sizes));
    if (dynamics.wheel) add_wheel(found, *dynamics.wheel);
    if (mechanism.space) add_pin(found, mechanism, dynamics.sizes);
  } catch (const base::InputError&) {
    return found.values();
  }
  return found.values();
}

}  // namespace

base::CaseHeader header_of(const Case& given) {
  return {name_of(given),
          given.title,
          fmt::format("{:%Y-%m-%dT%H:%M:%S%z}", fmt::localtime(std::time(nullptr))),
          given.units,
          given.content,
          given.project,
          given.author,
          given.completed,
          worked_out(given)};
}

}  // namespace geneva::model
