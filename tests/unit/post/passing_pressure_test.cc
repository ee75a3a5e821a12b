#include "post/output/passing_pressure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "post/output/passing_field.h"
#include "post/output/passing_mesh.h"

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
  const PressureEnvelope found = surface_pressure(passing_contact(own, {false, true}, curve(), 0.));
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
  const PressureEnvelope found = surface_pressure(passing_contact(own, {false, true}, curve(), 0.));
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

TEST(PassingContact, ReachesAsDeepAsItIsAsked) {
  const CycleFields own = nodes_of_slot(0.);
  const PassingContact found = passing_contact(own, {false, true}, curve(), 0.0101);
  for (std::size_t node = 0; node < 15; ++node) {
    const double x = own.fields.places[node][0];
    const double y = own.fields.places[node][1];
    if (y != 0.02 || x == 0.04) continue;
    EXPECT_NEAR(found.depth[node], 0.01, 1e-6 * pin_radius);
    EXPECT_NEAR(found.greatest.pressure[node], x <= 0.06 ? x : 0., 1e-12) << "the driving wall's";
  }
  const PassingContact shallow = passing_contact(own, {false, true}, curve(), 0.0099);
  EXPECT_EQ(shallow.greatest.pressure[11], 0.);
}

/// Stress of the instants: none.
Envelope nothing(const std::size_t nodes) {
  const std::vector<double> zeros(nodes, 0.);
  return {zeros, zeros, zeros, zeros, zeros, zeros, zeros};
}

TEST(PassingField, IsMcEwensBelowTheContact) {
  const CycleFields own = nodes_of_slot(0.);
  PassingContact passing = passing_contact(own, {false, true}, curve(), 0.02);
  const std::size_t node = 11;  // below the driving wall
  const double pressure = passing.greatest.pressure[node];
  ASSERT_GT(pressure, 0.);
  // Johnson, 4.49: the greatest in-plane shear is 0.300 p0 at 0.786 b, on the axis;
  // sigma_y = 0.3 (sigma_x + sigma_z) there.
  const double b = 1e-3;
  passing.depth[node] = 0.786 * b;
  Envelope found = nothing(own.fields.places.size());
  raise_to_passing_field(found, own.fields, passing, {b / pressure, 0., {0.3, 0.3}});
  EXPECT_NEAR(found.max_shear[node], 0.300 * pressure, 1e-3 * pressure);
  EXPECT_NEAR(found.von_mises[node], 0.5552 * pressure, 1e-4 * pressure);
  EXPECT_EQ(found.von_mises_when[node], passing.greatest.when[node]);
  EXPECT_EQ(found.first_principal[node], 0.) << "nothing but compression";
}

TEST(PassingField, HasTheTensionOfAContactThatSlides) {
  const CycleFields own = nodes_of_slot(0.);
  PassingContact passing = passing_contact(own, {false, true}, curve(), 0.02);
  const std::size_t node = 11;
  const double pressure = passing.greatest.pressure[node];
  passing.depth[node] = 0.;
  Envelope found = nothing(own.fields.places.size());
  raise_to_passing_field(found, own.fields, passing, {1e-3 / pressure, 0.25, {0.3, 0.3}});
  EXPECT_NEAR(found.first_principal[node], 0.5 * pressure, 0.01 * pressure) << "2 mu p0";
}

TEST(PassingField, LeavesWhatIsGreater) {
  const CycleFields own = nodes_of_slot(0.);
  const PassingContact passing = passing_contact(own, {false, true}, curve(), 0.02);
  Envelope found = nothing(own.fields.places.size());
  found.von_mises.assign(found.von_mises.size(), 1.);
  raise_to_passing_field(found, own.fields, passing, {0.1, 0., {0.3, 0.3}});
  for (const double stress : found.von_mises) EXPECT_EQ(stress, 1.);
}

/// Squares of the wheel beside the driving wall, of the size given, and one far from it.
CycleFields squares(const double size) {
  CycleFields result = nodes_of_slot(0.);
  const auto add = [&](const double x, const double y) {
    const std::size_t first = result.fields.places.size();
    for (const double dy : {0., size})
      for (const double dx : {0., size}) result.fields.places.push_back({x + dx, y + dy, 0.});
    result.fields.cells.push_back({first, first + 1, first + 2, first + 3});
    result.fields.bodies.push_back(0);
  };
  add(0.048, half_width);
  add(0.048, 3. * half_width);
  const std::size_t n_nodes = result.fields.places.size();
  result.fields.displacements.assign(n_nodes, {1., 2., 0.});
  result.fields.stress.assign(n_nodes, {1., 2., 3., 4., 5., 6.});
  result.fields.von_mises.assign(n_nodes, 7.);
  return result;
}

TEST(PassingMesh, IsFineBelowTheWallAndAsItWasElsewhere) {
  const double size = 0.004;
  CycleFields own = squares(size);
  // What the walls and the pin are known by are nodes, not quadrilaterals.
  for (std::size_t cell = 0; cell < own.fields.cells.size(); ++cell)
    own.fields.cells[cell].resize(4, own.fields.cells[cell].front());
  const double b = 2e-4;  // where p0 = 0.05
  const CycleFields fine = divided_where_passed(own, {false, true}, curve(), b / 0.05, 0.01);
  const auto at_wall = [&](const CycleFields& fields, const double height) {
    double largest = 0.;
    for (const auto& cell : fields.fields.cells) {
      const auto& low = fields.fields.places[cell[0]];
      const auto& high = fields.fields.places[cell[3]];
      if (std::abs(low[1] - height) < 1e-12) largest = std::max(largest, high[0] - low[0]);
    }
    return largest;
  };
  EXPECT_LE(at_wall(fine, half_width), 0.5 * b);
  EXPECT_NEAR(at_wall(fine, 3. * half_width), size, 1e-12) << "beyond its reach";
  EXPECT_EQ(fine.fields.bodies.size(), fine.fields.cells.size());
  EXPECT_EQ(fine.fields.stress.size(), fine.fields.places.size());
  EXPECT_EQ(fine.fields.von_mises.back(), 7.);
  EXPECT_NEAR(fine.fields.stress.back()[5], 6., 1e-12);
  double area = 0.;
  for (const auto& cell : fine.fields.cells) {
    const auto& low = fine.fields.places[cell[0]];
    const auto& high = fine.fields.places[cell[3]];
    area += (high[0] - low[0]) * (high[1] - low[1]);
  }
  EXPECT_NEAR(area, 2. * size * size, 1e-12) << "nothing is lost";
}

TEST(MissedDepth, IsThreeTimesHalfOfTheGreatestWayBetweenInstants) {
  EXPECT_NEAR(missed_depth({0.06, 0.04, 0.05}, 1e-4), 0.015, 1e-12);
  EXPECT_NEAR(missed_depth({0.06, 0.04, 0.05}, 0.01), 0.04, 1e-12);
}

}  // namespace
}  // namespace geneva::post
