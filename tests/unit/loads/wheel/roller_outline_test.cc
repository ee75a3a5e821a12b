#include "loads/wheel/roller_outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/wheel/outline_shapes.h"

namespace geneva::loads {
namespace {

constexpr double exact = 1e-15;

const Outline pin = pin_ring({0.3, 2e-3}, 0.014, 0.0035);

TEST(RollerOutlines, AreARingAndAStudThatTouchBelowTheDrivingWall) {
  const std::vector<Outline> outlines = roller_outlines(pin, {0.008, 1e-4, 0.002});
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_EQ(outlines[0].name, "pin");
  EXPECT_EQ(outlines[1].name, "stud");
  const double top_of_bore = 2e-3 + 0.004;
  const Segment& bore = outlines[0].loops[1].front();
  const Segment& stud = outlines[1].loops[0].front();
  for (const Segment& one : {bore, stud}) {
    EXPECT_NEAR(one.start.x, 0.3, exact);
    EXPECT_NEAR(one.start.y, top_of_bore, exact);
  }
  EXPECT_NEAR(stud.centre.y - bore.centre.y, 0.5e-4, exact) << "half the clearance";
}

TEST(RollerOutlines, HaveTheAreasOfTheirCircles) {
  const std::vector<Outline> outlines = roller_outlines(pin, {0.008, 1e-4, 0.002});
  EXPECT_NEAR(area_moments(outlines[0]).area, pi * (0.007 * 0.007 - 0.004 * 0.004), 1e-15);
  EXPECT_NEAR(area_moments(outlines[1]).area, pi * (0.00395 * 0.00395 - 0.002 * 0.002), 1e-15);
}

TEST(RollerOutlines, AreGuidedOnTheFarSideOfTheWall) {
  const std::vector<Outline> outlines = roller_outlines(pin, {0.008, 0., 0.002});
  for (const Loop& loop : outlines.front().loops) {
    ASSERT_EQ(loop.size(), 5U);
    const Segment& guide = loop[2];
    EXPECT_EQ(guide.surface, "roller guide");
    EXPECT_LT(guide.start.y, 2e-3);
    EXPECT_NEAR(0.5 * (guide.start.x + guide.end.x), 0.3, exact);
  }
}

TEST(RollerOutlines, RefuseWhatIsNoRoller) {
  EXPECT_THROW(roller_outlines(pin, {0.008, -1e-6, 0.002}), base::InputError);
  EXPECT_THROW(roller_outlines(pin, {0.008, 9e-4, 0.002}), base::InputError);
  EXPECT_THROW(roller_outlines(pin, {0.008, 1e-4, 0.004}), base::InputError);
}

}  // namespace
}  // namespace geneva::loads
