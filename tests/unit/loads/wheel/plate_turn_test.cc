#include "loads/wheel/plate_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "loads/wheel/outline_shapes.h"

namespace geneva::loads::test {
namespace {

/// Of which the lower edge is y = 0, from x = 0 on.
HeldPlate rectangle(const double width, const double height, const double poissons_ratio) {
  const Loop loop{line({0., 0.}, {width, 0.}, ""), line({width, 0.}, {width, height}, ""),
                  line({width, height}, {0., height}, ""), line({0., height}, {0., 0.}, "")};
  return {{"plate", {loop}}, nullptr, {}, 0.01, {2e11, poissons_ratio}};
}

/// Width t, length 8 t: the turn M L/(E I) of a beam, since a moment at its end shears nothing.
TEST(PlateTurn, OfAStripIsThatOfABeam) {
  HeldPlate plate = rectangle(0.01, 0.08, 0.);
  plate.is_held = [](const Point at) { return at.y > 0.08 - 1e-9; };
  const double inertia = std::pow(0.01, 4) / 12.;
  EXPECT_NEAR(plate_turn(plate, {0.005, 0.}) * 2e11 * inertia / 0.08, 1., 1e-9);
}

/// An arm 4 t wide, of which the far end is held: Saint-Venant's J = w t^3/3 (1 - 0.63 t/w). Its
/// held end cannot warp, and its loaded one gives way by itself, so that lengths are compared.
TEST(PlateTurn, OfALongArmGrowsAsItsTorsion) {
  const auto turn = [](const double length) {
    HeldPlate plate = rectangle(length, 0.04, 0.3);
    plate.is_held = [length](const Point at) { return at.x > length - 1e-9; };
    return plate_turn(plate, {0.02, 0.});
  };
  const double torsion = 0.04 * 1e-6 / 3. * (1. - 0.63 / 4.);
  const double shear_modulus = 2e11 / 2.6;
  EXPECT_NEAR((turn(0.5) - turn(0.3)) * shear_modulus * torsion / 0.2, 1., 0.06);
}

TEST(PlateTurn, IsTheSameMirrored) {
  HeldPlate plate = rectangle(0.1, 0.06, 0.3);
  plate.is_held = [](const Point at) { return at.x > 0.1 - 1e-9; };
  const double one = plate_turn(plate, {0.03, 0.});
  plate.is_held = [](const Point at) { return at.x < 1e-9; };
  EXPECT_NEAR(plate_turn(plate, {0.07, 0.}) / one, 1., 1e-9);
}

TEST(PlateTurn, DoesNotDependOnSizeAndModulus) {
  HeldPlate plate = rectangle(0.08, 0.04, 0.3);
  plate.is_held = [](const Point at) { return at.y > 0.04 - 1e-9; };
  const double small = plate_turn(plate, {0.04, 0.}) * 2e11 * 1e-6;
  HeldPlate large = rectangle(0.8, 0.4, 0.3);
  large.is_held = [](const Point at) { return at.y > 0.4 - 1e-9; };
  large.thickness = 0.1;
  large.material.youngs_modulus = 1e9;
  EXPECT_NEAR(plate_turn(large, {0.4, 0.}) * 1e9 * 1e-3 / small, 1., 1e-8);
}

TEST(PlateTurn, WantsAPlateThatIsHeldAndReachesItsLoad) {
  HeldPlate plate = rectangle(0.08, 0.04, 0.3);
  plate.is_held = [](const Point&) { return false; };
  EXPECT_THROW(plate_turn(plate, {0.04, 0.}), base::InputError);
}

}  // namespace
}  // namespace geneva::loads::test
