#include "post/output/passing_pressure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geneva::post {
namespace {

constexpr double half_width = 0.01;
constexpr double pin_radius = 0.0095;
const double axis_y = half_width - pin_radius;

/// Nodes on both walls and away from them, and round the pin, whose axis is at x = 0.05.
CycleFields nodes_of_slot(const double pin_turn) {
  CycleFields result{0., 0.05, pin_turn, {}};
  const auto add = [&](const double x, const double y, const unsigned int body) {
    result.fields.cells.push_back({result.fields.places.size()});
    result.fields.bodies.push_back(body);
    result.fields.places.push_back({x, y, 0.});
  };
  for (const double y : {half_width, -half_width, 0.02})
    for (const double x : {0.04, 0.045, 0.05, 0.055, 0.07}) add(x, y, 0);
  for (const double y : {0.004, -0.006, 0.007}) add(0.043, y, 0);  // round bottom of the slot
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::acos(-1.) / 4.;
    add(0.05 + pin_radius * std::cos(angle), axis_y + pin_radius * std::sin(angle), 1);
  }
  return result;
}

/// The pin goes in from 0.06 to 0.04 on the driving wall and back on the braking one, and turns by
/// half a turn; the pressure is the pin's distance, on the braking wall half of it.
std::vector<CycleCurvePoint> curve() {
  std::vector<CycleCurvePoint> points;
  for (int i = 0; i <= 40; ++i) {
    CycleCurvePoint point{};
    point.driver_angle = 0.01 * i;
    const bool drives = i <= 20;
    point.force = drives ? 1. : -1.;
    point.pin_distance = drives ? 0.06 - 0.001 * i : 0.02 + 0.001 * i;
    point.pin_turn = std::acos(-1.) * i / 40.;
    point.peak_pressure = (drives ? 1. : 0.5) * point.pin_distance;
    points.push_back(point);
  }
  return points;
}

TEST(PassingPressure, IsOnAWallThatOfThePinBesideIt) {
  const CycleFields own = nodes_of_slot(0.);
  const PressureEnvelope found = passing_pressure(own, {false, true}, curve());
  for (std::size_t node = 0; node < 15; ++node) {
    const double x = own.fields.places[node][0];
    const double y = own.fields.places[node][1];
    const double share = y == half_width ? 1. : y == -half_width ? 0.5 : 0.;
    const bool is_passed = x >= 0.041 && x <= 0.06;
    if (x == 0.04) continue;  // where the pin turns back
    EXPECT_NEAR(found.pressure[node], is_passed ? share * x : 0., 1e-12) << x << ' ' << y;
    if (share == 1. && is_passed) {
      EXPECT_NEAR(found.when[node], 10. * (0.06 - x), 1e-9) << x;
    }
  }
}

TEST(PassingPressure, IsOnThePinThatOfTheMomentWhenItFacesTheWall) {
  const double own_turn = 0.3;
  const CycleFields own = nodes_of_slot(own_turn);
  const PressureEnvelope found = passing_pressure(own, {false, true}, curve());
  int faced = 0;
  for (std::size_t node = 18; node < 26; ++node) {
    const double angle = std::atan2(own.fields.places[node][1] - axis_y,
                                    own.fields.places[node][0] - own.pin_distance);
    if (found.pressure[node] == 0.) continue;
    ++faced;
    const double driver = found.when[node];
    const double turn = std::acos(-1.) * driver / 0.4;
    const double wall = driver <= 0.2 ? std::acos(0.) : -std::acos(0.);
    EXPECT_NEAR(std::remainder(angle - (turn - own_turn) - wall, 4. * std::acos(0.)), 0., 1e-9);
  }
  EXPECT_GE(faced, 2);
}

}  // namespace
}  // namespace geneva::post
