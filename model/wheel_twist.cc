#include "model/wheel_twist.h"

#include <cmath>
#include <variant>

#include "loads/wheel/internal_outline.h"
#include "loads/wheel/local_outline.h"
#include "loads/wheel/plate_turn.h"
#include "model/block_dimensions.h"

namespace geneva::model {

namespace {

using loads::HeldPlate;
using loads::Point;

/// Held on this side of a circle around the wheel's axis, less rounding.
constexpr double on_circle = 1. + 1e-6;

HeldPlate plate_of(const loads::GenevaDimensions& wheel) {
  const double bore = wheel.bore_radius;
  const double bottom = slot_bottom_centre(wheel);
  return {loads::wheel_outline(wheel),
          [bore](const Point at) { return std::hypot(at.x, at.y) <= on_circle * bore; },
          {{0., 0.}, {bore, bore}, {-bore, -bore}, {bottom, wheel.slot_width / 2.}},
          wheel.thickness,
          {}};
}

HeldPlate plate_of(const loads::InternalDimensions& wheel) {
  const double rim = wheel.rim_radius;
  const double bottom = slot_bottom_centre(wheel);
  return {loads::internal_wheel_outline(wheel),
          [rim](const Point at) { return on_circle * std::hypot(at.x, at.y) >= rim; },
          {{bottom, wheel.slot_width / 2.}},
          wheel.thickness,
          {}};
}

/// A block whose wall is y = 0; its back is held, and its sides if they are to be.
HeldPlate block(const loads::Outline& outline, const loads::LocalDimensions& sizes,
                const bool are_sides_held, const double thickness) {
  const double back = sizes.depth / on_circle;
  const double side = are_sides_held ? sizes.width / 2. / on_circle : sizes.width;
  return {outline,
          [back, side](const Point at) { return at.y >= back || std::abs(at.x) >= side; },
          {},
          thickness,
          {}};
}

/// What the table of the slab kernel holds already.
HeldPlate tabulated_block(const double thickness) {
  const loads::LocalDimensions sizes{thickness, thickness / 4., 8. * thickness, 4. * thickness};
  return block(loads::local_outlines(sizes).front(), sizes, true, thickness);
}

double turn(HeldPlate plate, const loads::Elastic& material, const Point at) {
  plate.material = material;
  return loads::plate_turn(plate, at);
}

}  // namespace

double wheel_twist(const MechanismCase& mechanism, const MechanismState& state) {
  const loads::Elastic material{mechanism.wheel.youngs_modulus, mechanism.wheel.poissons_ratio};
  const double thickness = state.sizes.thickness;
  const double known = turn(tabulated_block(thickness), material, {0., 0.});
  if (mechanism.is_local || !state.wheel) {
    const loads::LocalDimensions sizes = block_dimensions(mechanism, state.sizes);
    const loads::Outline outline = loads::local_outlines(sizes).front();
    return turn(block(outline, sizes, false, thickness), material, {0., 0.}) - known;
  }
  return std::visit(
             [&](const auto& wheel) {
               return turn(plate_of(wheel), material,
                           {state.load.pin_distance, wheel.slot_width / 2.});
             },
             *state.wheel) -
         known;
}

}  // namespace geneva::model
