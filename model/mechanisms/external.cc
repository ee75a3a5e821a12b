#include "loads/motion/external_geneva.h"

#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

class External : public MechanismType {
 public:
  [[nodiscard]] loads::Mechanism mechanism(const Sizes& sizes) const override {
    return loads::external_geneva(sizes.stations, centre_distance(sizes));
  }
  [[nodiscard]] bool is_drawn() const override { return true; }
  [[nodiscard]] std::optional<DrawnWheel> drawn_wheel(const Sizes& sizes) const override {
    return loads::complete_dimensions(sizes);
  }
  [[nodiscard]] bool is_johnsons() const override { return true; }
  [[nodiscard]] std::optional<loads::PlaneGeneva> plane() const override {
    return loads::PlaneGeneva::external;
  }
};

}  // namespace

MechanismKind external_kind() {
  MechanismKind kind;
  kind.name = "external";
  kind.help = "the slots open outwards.";
  kind.sizes = {"Wheel diameter", "Crank radius", "Centre distance"};
  kind.unused = {"Rim radius"};
  kind.read = [](const CaseValues&, const MechanismType::Sizes&) {
    return std::make_shared<External>();
  };
  return kind;
}

}  // namespace geneva::model
