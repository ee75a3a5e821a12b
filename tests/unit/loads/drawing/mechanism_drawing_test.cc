#include <gtest/gtest.h>

#include <cmath>

#include "loads/design/johnson.h"
#include "loads/drawing/mechanism_drawing.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"

namespace {

using namespace geneva::loads;

TEST(PinPlace, GoesRoundTheDriversAxisAlsoWhileTheWheelRests) {
  const double centre = 0.1;
  const double crank = centre * std::sin(pi / 5);
  for (int step = -10; step < 10; ++step) {
    const double angle = 0.3 * step;
    const Place outside = pin_place(external_geneva(5, centre).motion(angle));
    EXPECT_NEAR(outside.x, centre - crank * std::cos(angle), 1e-15);
    EXPECT_NEAR(outside.y, crank * std::sin(angle), 1e-15);
    const Place inside = pin_place(internal_geneva(5, centre).motion(angle));
    EXPECT_NEAR(inside.x, centre + crank * std::cos(angle), 1e-15);
    EXPECT_NEAR(inside.y, crank * std::sin(angle), 1e-15);
  }
}

TEST(PinPlace, OfASphericalGenevaIsOnTheSphereAtTheSameAngleFromTheDriversAxis) {
  const double shaft = 1.2;
  const Mechanism mechanism = spherical_geneva(6, shaft, 0.05);
  const double cosine = std::sqrt(1. - std::pow(std::sin(shaft) * std::sin(pi / 6), 2));
  for (int step = -10; step < 10; ++step) {
    const double angle = 0.3 * step;
    const Place pin = pin_place(mechanism.motion(angle));
    EXPECT_NEAR(std::hypot(pin.x, pin.y, pin.z), 0.05, 1e-15);
    EXPECT_NEAR((pin.x * std::sin(shaft) + pin.z * std::cos(shaft)) / 0.05, cosine, 1e-14);
  }
}

TEST(PinPath, IsClosed) {
  const Polyline path = pin_path(external_geneva(4, 1.), 100);
  EXPECT_EQ(path.size(), 101);
  EXPECT_NEAR(path.front().x, path.back().x, 1e-15);
  EXPECT_NEAR(path.front().y, path.back().y, 1e-15);
}

double area(const Polyline& line) {
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    sum += 0.5 * (line[i].x * line[i + 1].y - line[i + 1].x * line[i].y);
  return sum;
}

TEST(Polylines, EncloseTheOutlinesArea) {
  const Outline wheel = wheel_outline(complete_dimensions([] {
    GenevaDimensionsInput input{};
    input.stations = 6;
    input.wheel_diameter = 0.1;
    return input;
  }()));
  double sum = 0.;
  for (const Polyline& line : polylines(wheel)) sum += area(line);
  EXPECT_NEAR(sum / area_moments(wheel).area, 1., 1e-3);
}

TEST(SchematicWheel, HasTheRimLessTheSlots) {
  const Mechanism mechanism = external_geneva(8, 1.);
  const double rim = mechanism.motion(mechanism.entry).pin_distance.value;
  const double bottom = mechanism.motion(0.).pin_distance.value;
  const double width = 0.02;
  const double slots = 8. * (width * (rim - bottom) + pi * width * width / 8.);
  const double drawn = area(schematic_wheel(mechanism, width));
  EXPECT_NEAR(drawn / (pi * rim * rim - slots), 1., 2e-3);
}

TEST(SchematicWheel, OfASphericalGenevaLiesOnTheSphere) {
  for (const Place& place : schematic_wheel(spherical_geneva(8, pi / 2., 0.08), 0.01))
    EXPECT_NEAR(std::hypot(place.x, place.y, place.z), 0.08, 1e-15);
}

}  // namespace
