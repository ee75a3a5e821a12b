#include "model/contact_geometry.h"

#include <stdexcept>
#include <utility>

#include "loads/wheel/internal_outline.h"
#include "loads/wheel/local_outline.h"
#include "loads/wheel/roller_outline.h"
#include "model/block_dimensions.h"

namespace geneva::model {

namespace {

ContactGeometry local_geometry(const MechanismCase& mechanism, const MechanismSizes& sizes) {
  const loads::LocalDimensions dimensions = block_dimensions(mechanism, sizes);
  return {loads::local_outlines(dimensions), mesh::default_sizing(dimensions), "back"};
}

ContactGeometry geometry_of(const loads::GenevaDimensions& wheel, const double pin_distance) {
  return {{loads::wheel_outline(wheel), loads::pin_outline(wheel, pin_distance)},
          mesh::default_sizing(wheel, pin_distance),
          "bore"};
}

ContactGeometry geometry_of(const loads::InternalDimensions& wheel, const double pin_distance) {
  return {{loads::internal_wheel_outline(wheel), loads::internal_pin_outline(wheel, pin_distance)},
          mesh::default_sizing(wheel, pin_distance),
          "rim"};
}

/// The pin, which comes last, as a roller on its stud.
std::vector<loads::Outline> with_roller(std::vector<loads::Outline> outlines,
                                        const MechanismCase& mechanism) {
  const double bore = mechanism.roller->diameter;
  const double clearance = *mechanism.bore_clearance;
  const double core = stud_core_radius(mechanism);
  const loads::Outline pin = outlines.back();
  outlines.pop_back();
  for (loads::Outline& outline : loads::roller_outlines(pin, {bore, clearance, core}))
    outlines.push_back(std::move(outline));
  return outlines;
}

ContactGeometry solid_geometry(const MechanismCase& mechanism, const MechanismState& state) {
  if (mechanism.is_local) return local_geometry(mechanism, state.sizes);
  if (!state.wheel) throw std::logic_error("the whole wheel of this type is not drawn");
  return std::visit([&](const auto& wheel) { return geometry_of(wheel, state.load.pin_distance); },
                    *state.wheel);
}

}  // namespace

ContactGeometry contact_geometry(const MechanismCase& mechanism, const MechanismState& state) {
  ContactGeometry geometry = solid_geometry(mechanism, state);
  if (mechanism.bore_clearance)
    geometry.outlines = with_roller(std::move(geometry.outlines), mechanism);
  return geometry;
}

}  // namespace geneva::model
