#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "loads/pi.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

const std::vector<MechanismKind>& mechanism_kinds() {
  static const std::vector<MechanismKind> kinds{external_kind(), internal_kind(), spherical_kind(),
                                                long_dwell_kind(), four_bar_kind()};
  return kinds;
}

const MechanismKind& mechanism_kind(const std::string& name) {
  const auto& kinds = mechanism_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const MechanismKind& kind) { return kind.name == name; });
  if (found == kinds.end()) throw std::logic_error("there is no type of mechanism '" + name + "'");
  return *found;
}

std::vector<std::string> lengths_of_drawings() {
  return {"Slot clearance", "Slot width",  "Slot depth",
          "Locking radius", "Bore radius", "Rim radius"};
}

double crank_radius(const MechanismType::Sizes& sizes) {
  const double half_pitch = loads::pi / sizes.stations;
  if (sizes.crank_radius) return *sizes.crank_radius;
  if (sizes.centre_distance) return *sizes.centre_distance * std::sin(half_pitch);
  return *sizes.wheel_diameter / 2. * std::tan(half_pitch);
}

double centre_distance(const MechanismType::Sizes& sizes) {
  return sizes.centre_distance ? *sizes.centre_distance
                               : crank_radius(sizes) / std::sin(loads::pi / sizes.stations);
}

}  // namespace geneva::model
