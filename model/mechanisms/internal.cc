#include "loads/motion/internal_geneva.h"

#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

class Internal : public MechanismType {
 public:
  explicit Internal(const std::optional<double> rim_radius) : rim_radius_(rim_radius) {}

  [[nodiscard]] loads::Mechanism mechanism(const Sizes& sizes) const override {
    return loads::internal_geneva(sizes.stations, centre_distance(sizes));
  }
  [[nodiscard]] bool is_drawn() const override { return true; }
  [[nodiscard]] std::optional<DrawnWheel> drawn_wheel(const Sizes& sizes) const override {
    return loads::complete_internal_dimensions({sizes, rim_radius_});
  }
  [[nodiscard]] std::optional<loads::PlaneGeneva> plane() const override {
    return loads::PlaneGeneva::internal;
  }

 private:
  std::optional<double> rim_radius_;  ///< [m]
};

}  // namespace

MechanismKind internal_kind() {
  MechanismKind kind;
  kind.name = "internal";
  kind.help = "a ring wheel whose slots open inwards.";
  kind.sizes = {"Wheel diameter", "Crank radius", "Centre distance"};
  kind.unused = {"Bore radius"};
  kind.read = [](const CaseValues& values, const MechanismType::Sizes&) {
    return std::make_shared<Internal>(values.value({names::mechanism}, "Rim radius"));
  };
  return kind;
}

}  // namespace geneva::model
