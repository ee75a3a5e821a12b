#include "loads/wheel/local_outline.h"

#include "loads/require.h"
#include "loads/wheel/common_dimensions.h"
#include "loads/wheel/outline_shapes.h"
#include "loads/wheel/refuse.h"

namespace geneva::loads {

namespace {

/// A block smaller than the pin's half that faces it is no model of a wall.
void check_block(const LocalDimensions& dimensions) {
  const double diameter = dimensions.pin_diameter;
  if (dimensions.width < diameter)
    refuse(
        "block width is {:.6g} mm: it must be at least the pin diameter {:.6g} mm; make the block "
        "wider or the pin smaller",
        mm(dimensions.width), mm(diameter));
  if (dimensions.depth < diameter / 2.)
    refuse(
        "block depth is {:.6g} mm: it must be at least half the pin diameter, {:.6g} mm; make the "
        "block deeper or the pin smaller",
        mm(dimensions.depth), mm(diameter / 2.));
}

}  // namespace

void check(const LocalDimensions& dimensions) {
  require_positive_length("pin diameter", dimensions.pin_diameter);
  require_positive_length("pin core radius", dimensions.pin_core_radius);
  require_positive_length("block width", dimensions.width);
  require_positive_length("block depth", dimensions.depth);
  check_core(dimensions.pin_core_radius, dimensions.pin_diameter);
  check_block(dimensions);
}

std::vector<Outline> local_outlines(const LocalDimensions& dimensions) {
  check(dimensions);
  const double right = dimensions.width / 2.;
  const double depth = dimensions.depth;
  const Loop block{
      line({-right, 0.}, {right, 0.}, "driving wall"), line({right, 0.}, {right, depth}, "sides"),
      line({right, depth}, {-right, depth}, "back"), line({-right, depth}, {-right, 0.}, "sides")};
  const Point centre{0., -dimensions.pin_diameter / 2.};
  return {{"wheel", {block}},
          pin_ring(centre, dimensions.pin_diameter, dimensions.pin_core_radius)};
}

}  // namespace geneva::loads
