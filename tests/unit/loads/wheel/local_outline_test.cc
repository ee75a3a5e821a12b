#include "loads/wheel/local_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/wheel/outline_shape.h"

namespace geneva::loads {
namespace {

using test::expect_closed;
using test::expect_refused;

/// Areas of about 1e-3 m^2: a few roundings.
constexpr double round_off = 1e-17;

const LocalDimensions usual{0.010, 0.0025, 0.040, 0.030};

TEST(LocalOutlines, AreABlockAndAPinOfTheirAreas) {
  const std::vector<Outline> bodies = local_outlines(usual);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].name, "wheel");
  EXPECT_EQ(bodies[1].name, "pin");
  for (const Outline& body : bodies) expect_closed(body);
  const AreaMoments block = area_moments(bodies[0]);
  EXPECT_NEAR(block.area, 0.040 * 0.030, round_off);
  EXPECT_NEAR(block.centroid.x, 0., round_off);
  EXPECT_NEAR(block.centroid.y, 0.015, 1e-16);
  const AreaMoments pin = area_moments(bodies[1]);
  EXPECT_NEAR(pin.area, pi * (0.005 * 0.005 - 0.0025 * 0.0025), round_off);
  EXPECT_NEAR(pin.centroid.x, 0., round_off);
  EXPECT_NEAR(pin.centroid.y, -0.005, 1e-16);
}

TEST(LocalOutlines, NameTheFacesOfTheBlock) {
  std::map<std::string, int> count;
  const Outline block = local_outlines(usual)[0];
  for (const Segment& segment : block.loops.at(0)) {
    ++count[segment.surface];
    EXPECT_FALSE(segment.is_arc);
    const Point middle{(segment.start.x + segment.end.x) / 2.,
                       (segment.start.y + segment.end.y) / 2.};
    if (segment.surface == "driving wall") {
      EXPECT_EQ(middle.y, 0.);
    }
    if (segment.surface == "back") {
      EXPECT_EQ(middle.y, 0.030);
    }
    if (segment.surface == "sides") {
      EXPECT_EQ(std::abs(middle.x), 0.020);
    }
  }
  EXPECT_EQ(count, (std::map<std::string, int>{{"driving wall", 1}, {"back", 1}, {"sides", 2}}));
}

TEST(LocalOutlines, TouchAtTheOriginWithTheFirstVertexOfThePin) {
  for (const double diameter : {0.01, 0.3, 1. / 3.}) {
    const Outline pin = local_outlines({diameter, diameter / 5., 4., 3.})[1];
    EXPECT_EQ(pin.loops[0][0].start.x, 0.);
    EXPECT_EQ(pin.loops[0][0].start.y, 0.);
    for (const Segment& segment : pin.loops[0]) EXPECT_EQ(segment.surface, "pin");
    for (const Segment& segment : pin.loops[1]) EXPECT_EQ(segment.surface, "pin core");
  }
}

TEST(LocalOutlines, RefuseLengthsThatAreNotPositiveAndFinite) {
  struct Length {
    const char* name;
    double LocalDimensions::*member;
  };
  const Length lengths[] = {{"pin diameter", &LocalDimensions::pin_diameter},
                            {"pin core radius", &LocalDimensions::pin_core_radius},
                            {"block width", &LocalDimensions::width},
                            {"block depth", &LocalDimensions::depth}};
  for (const Length& length : lengths) {
    const std::string name = length.name;
    LocalDimensions local = usual;
    local.*length.member = -3e-3;
    expect_refused([&] { local_outlines(local); }, {name + " is -3 mm", "must be positive"});
    local.*length.member = 0.;
    expect_refused([&] { local_outlines(local); }, {name + " is 0 mm"});
    local.*length.member = std::numeric_limits<double>::quiet_NaN();
    expect_refused([&] { local_outlines(local); }, {name + " is nan mm", "finite"});
    local.*length.member = std::numeric_limits<double>::infinity();
    expect_refused([&] { local_outlines(local); }, {name + " is inf mm", "finite"});
  }
}

TEST(LocalOutlines, RefuseABlockSmallerThanThePinsHalf) {
  LocalDimensions local = usual;
  local.width = 0.0099;
  expect_refused([&] { local_outlines(local); },
                 {"block width is 9.9 mm", "pin diameter 10 mm", "wider"});
  local.width = 0.010;
  local.depth = 0.0049;
  expect_refused([&] { local_outlines(local); },
                 {"block depth is 4.9 mm", "half the pin diameter, 5 mm", "deeper"});
  local.depth = 0.005;
  EXPECT_NO_THROW(local_outlines(local));
}

TEST(LocalOutlines, RefuseACoreThatFillsThePin) {
  LocalDimensions local = usual;
  local.pin_core_radius = 0.005;
  expect_refused([&] { local_outlines(local); },
                 {"pin core radius is 5 mm", "inside the pin of radius 5 mm", "smaller"});
}

}  // namespace
}  // namespace geneva::loads
