#include "model/block_dimensions.h"

namespace geneva::model {

namespace {

/// The peak pressure changes by less than 0.1 % with larger blocks.
constexpr double block_width_over_pin = 4.;
constexpr double block_depth_over_pin = 2.;

}  // namespace

loads::LocalDimensions block_dimensions(const MechanismCase& mechanism,
                                        const MechanismSizes& sizes) {
  const double d = sizes.pin_diameter;
  return {d, mechanism.dimensions.pin_core_radius.value_or(d / 4.),
          mechanism.block_width.value_or(block_width_over_pin * d),
          mechanism.block_depth.value_or(block_depth_over_pin * d)};
}

}  // namespace geneva::model
