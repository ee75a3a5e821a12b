#include "loads/motion/slip.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/four_bar_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"

namespace geneva::loads {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double centre_distance = 0.1;
constexpr double pin_diameter = 0.012;

/// Pin and carrier of a mechanism as bodies in 3-D, drawn without the program's kinematics: the
/// wheel's axis is the z axis through the origin.
struct Bodies {
  std::string name;
  Mechanism mechanism;
  std::function<Vector3d(double angle)> pin;  ///< place of its axis
  /// Where a point of the carrier goes from one driver angle to another.
  std::function<Vector3d(const Vector3d& point, double from, double to)> carried;
  double sense = 1.;  ///< of the wheel about the z axis
};

Vector3d turned(const Vector3d& point, const Vector3d& centre, const Vector3d& axis,
                const double angle) {
  return centre + AngleAxisd(angle, axis) * (point - centre);
}

Bodies crank(const std::string& name, const Mechanism& mechanism, const double side) {
  const Vector3d axis(centre_distance, 0., 0.);
  const double radius = centre_distance * std::sin(pi / mechanism.stations);
  // external: side = -1, the crank points at the wheel at 0 and turns clockwise
  const auto carried = [=](const Vector3d& point, const double from, const double to) {
    return turned(point, axis, Vector3d::UnitZ(), side * (to - from));
  };
  const auto pin = [=](const double angle) {
    return carried(axis + Vector3d(side * radius, 0., 0.), 0., angle);
  };
  return {name, mechanism, pin, carried};
}

Bodies sphere(const double shaft_angle) {
  const Vector3d axis(std::sin(shaft_angle), 0., std::cos(shaft_angle));
  const double cone = std::asin(std::sin(shaft_angle) * std::sin(pi / 5));
  const Vector3d middle(std::sin(shaft_angle - cone), 0., std::cos(shaft_angle - cone));
  const auto carried = [=](const Vector3d& point, const double from, const double to) {
    return turned(point, Vector3d::Zero(), axis, from - to);
  };
  return {
      "spherical " + std::to_string(shaft_angle), spherical_geneva(5, shaft_angle, centre_distance),
      [=](const double angle) { return carried(centre_distance * middle, 0., angle); }, carried};
}

/// A chain link points along the path of the pin, whose direction is taken from its places.
Bodies chain(const std::string& name, const Mechanism& mechanism) {
  const auto pin = [=](const double angle) {
    const SlotMotion motion = mechanism.motion(angle);
    return Vector3d(motion.pin_distance.value * std::cos(motion.wheel_angle.value),
                    motion.pin_distance.value * std::sin(motion.wheel_angle.value), 0.);
  };
  const auto heading = [=](const double angle) {
    constexpr double h = 1e-4;
    const Vector3d way =
        8. * (pin(angle + h) - pin(angle - h)) - (pin(angle + 2. * h) - pin(angle - 2. * h));
    return std::atan2(way[1], way[0]);
  };
  const auto carried = [=](const Vector3d& point, const double from, const double to) {
    const AngleAxisd turn(heading(to) - heading(from), Vector3d::UnitZ());
    return Vector3d(pin(to) + turn * (point - pin(from)));
  };
  return {name, mechanism, pin, carried};
}

/// A point of the coupler moves with the end of the crank and the pin.
/// @param side -1: mirrored at the frame, so that the wheel turns the other way
Bodies coupler(const double side) {
  const double direction = side * 150. * degree;
  const Assembly assembly = side > 0. ? Assembly::open : Assembly::crossed;
  const FourBar linkage{{0., 0.}, {0.1, 0.}, 0.04, 0.12, 0.12, 0.12, side * pi / 2.};
  const FourBarGeneva found = four_bar_geneva(6, linkage, assembly, {direction, std::nullopt});
  const Vector3d wheel(found.centre_distance * std::cos(direction),
                       found.centre_distance * std::sin(direction), 0.);
  const auto end = [=](const double angle) {
    const double crank = found.crank_angle + angle;
    return Vector3d(0.04 * std::cos(crank) - wheel[0], 0.04 * std::sin(crank) - wheel[1], 0.);
  };
  const auto pin = [=](const double angle) {
    const FourBarMotion state = motion(linkage, assembly, found.crank_angle + angle);
    return Vector3d(state.x[0] - wheel[0], state.y[0] - wheel[1], 0.);
  };
  const auto carried = [=](const Vector3d& point, const double from, const double to) {
    const Vector3d before = pin(from) - end(from);
    const Vector3d after = pin(to) - end(to);
    const double angle = std::atan2(before.cross(after)[2], before.dot(after));
    return Vector3d(pin(to) + AngleAxisd(angle, Vector3d::UnitZ()) * (point - pin(from)));
  };
  const double sense = pin(0.).cross(pin(1e-3))[2] > 0. ? 1. : -1.;
  return {"four-bar " + std::to_string(direction), found.mechanism, pin, carried, sense};
}

std::vector<Bodies> every_mechanism() {
  return {crank("external 3", external_geneva(3, centre_distance), -1.),
          crank("external 4", external_geneva(4, centre_distance), -1.),
          crank("external 9", external_geneva(9, centre_distance), -1.),
          crank("internal 3", internal_geneva(3, centre_distance), 1.),
          crank("internal 6", internal_geneva(6, centre_distance), 1.),
          sphere(0.4),
          sphere(pi / 2.),
          sphere(2.6),
          chain("along", long_dwell_geneva(5, 0.04, 0.06, SprocketLine::along_line_of_centres)),
          chain("across", long_dwell_geneva(5, 0.04, 0.06, SprocketLine::across_line_of_centres)),
          coupler(1.),
          coupler(-1.)};
}

/// Directions of the slot at a driver angle: along it away from the wheel's axis, and across it
/// towards the driving wall.
struct SlotFrame {
  Vector3d along;
  Vector3d across;
};

SlotFrame slot_frame(const Bodies& bodies, const double angle) {
  const Vector3d out = bodies.pin(angle).normalized();
  const bool is_plane = std::abs(out[2]) < 1e-12;
  const Vector3d across = (bodies.sense * Vector3d::UnitZ().cross(out)).normalized();
  // on a sphere the slot runs across the pin, in the plane of the pin and the wheel's axis
  return {is_plane ? out : Vector3d(across.cross(out)), across};
}

double azimuth(const Vector3d& place) { return std::atan2(place[1], place[0]); }

/// Velocity, per time, of the material point of the pin at a wall, as seen from the wheel.
/// @param angle_at driver angle at a time
Vector3d sliding(const Bodies& bodies, const std::function<double(double)>& angle_at,
                 const double time, const double h, const Vector3d& from_axis) {
  const double here = angle_at(time);
  const Vector3d point = bodies.pin(here) + from_axis;
  const auto place = [&](const double at) {
    const double angle = angle_at(at);
    const double wheel = azimuth(bodies.pin(angle)) - azimuth(bodies.pin(here));
    return Vector3d(AngleAxisd(-wheel, Vector3d::UnitZ()) * bodies.carried(point, here, angle));
  };
  return (45. * (place(time + h) - place(time - h)) -
          9. * (place(time + 2. * h) - place(time - 2. * h)) +
          (place(time + 3. * h) - place(time - 3. * h))) /
         (60. * h);
}

/// The material points of a fixed pin slide along the walls by the formula, and not into them.
TEST(SurfaceSpeed, IsThatOfTheMaterialPointsOfEveryMechanism) {
  const double scale = centre_distance;  // per radian of the driver
  for (const Bodies& bodies : every_mechanism())
    for (const double part : {-0.93, -0.61, -0.2, 0.05, 0.33, 0.77}) {
      const double angle = part * (part < 0. ? -bodies.mechanism.entry : bodies.mechanism.exit);
      const SlotMotion motion = bodies.mechanism.motion(angle);
      const SlotFrame slot = slot_frame(bodies, angle);
      for (const Wall wall : {Wall::driving, Wall::braking}) {
        const double side = wall == Wall::driving ? 1. : -1.;
        const Vector3d velocity = sliding(
            bodies, [](const double at) { return at; }, angle, 2e-3,
            side * pin_diameter / 2. * slot.across);
        EXPECT_NEAR(surface_speed(motion.slot_position, motion.pin_turn, pin_diameter, wall),
                    velocity.dot(slot.along), 1e-9 * scale)
            << bodies.name << " at " << angle;
        EXPECT_NEAR(velocity.dot(slot.across), 0., 1e-9 * scale)
            << bodies.name << ": the pin goes into the wall";
      }
    }
}

/// With respect to time, whatever moves the driver.
TEST(SurfaceSpeed, IsThatOfTheMaterialPointsOfMovedDrivers) {
  std::vector<std::pair<Bodies, Drive>> all;
  const std::vector<double> times{0., 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const std::vector<double> angles{-4., -2.2, -0.9, 0.2, 1.1, 2.4, 4.2};
  for (const Bodies& bodies : every_mechanism()) {
    const auto pins = engagements(bodies.mechanism, {0.});
    all.emplace_back(bodies, constant_acceleration(bodies.mechanism, pins, 20., 30.));
    all.emplace_back(bodies, table(pins, times, angles));
    for (const MotionLaw law : {MotionLaw::harmonic, MotionLaw::cycloidal})
      all.emplace_back(bodies, law_on_carrier(bodies.mechanism, pins, law, 0.1));
  }
  for (const MotionLaw law : {MotionLaw::harmonic, MotionLaw::cycloidal})
    for (const bool is_external : {true, false}) {
      const Mechanism mechanism =
          is_external ? external_geneva(5, centre_distance) : internal_geneva(5, centre_distance);
      all.emplace_back(
          crank("law on the cross", mechanism, is_external ? -1. : 1.),
          law_on_cross(mechanism, is_external ? PlaneGeneva::external : PlaneGeneva::internal,
                       centre_distance, engagements(mechanism, {0.}), law, 0.1));
    }
  for (const auto& [bodies, drive] : all) {
    const DrivenMechanism driven(bodies.mechanism, engagements(bodies.mechanism, {0.}), drive);
    const TimedEngagement& engagement = driven.engagements().front();
    const double length = engagement.end - engagement.begin;
    const auto angle_at = [&](const double time) {
      return driven.at_time(time).driver_angle.value;
    };
    for (const double part : {0.12, 0.31, 0.46, 0.83}) {
      const double time = engagement.begin + part * length;
      const MotionState state = driven.at_time(time);
      const SlotFrame slot = slot_frame(bodies, state.driver_angle.value);
      for (const Wall wall : {Wall::driving, Wall::braking}) {
        const double side = wall == Wall::driving ? 1. : -1.;
        const Vector3d velocity =
            sliding(bodies, angle_at, time, 5e-4 * length, side * pin_diameter / 2. * slot.across);
        EXPECT_NEAR(surface_speed(state.slot_position, state.pin_turn, pin_diameter, wall),
                    velocity.dot(slot.along), 1e-8 * centre_distance / length)
            << bodies.name << " at " << time;
      }
    }
  }
}

TEST(SurfaceSpeed, IsNoneOnNoWallAndThatOfTheAxisWithoutDiameter) {
  const SlotMotion motion = external_geneva(4, centre_distance).motion(0.3);
  EXPECT_EQ(surface_speed(motion.slot_position, motion.pin_turn, pin_diameter, Wall::none), 0.);
  for (const Wall wall : {Wall::driving, Wall::braking})
    EXPECT_EQ(surface_speed(motion.slot_position, motion.pin_turn, 0., wall),
              motion.slot_position.first);
}

/// In the plane a pin makes half a turn in its slot; on a sphere it turns by the angle between the
/// planes of both axes.
TEST(PinTurn, IsHalfATurnInAnExternalGeneva) {
  for (int n = 3; n <= 24; ++n) {
    const Mechanism mechanism = external_geneva(n, centre_distance);
    EXPECT_NEAR(mechanism.motion(mechanism.exit).pin_turn.value, pi / 2., 1e-14) << n;
    EXPECT_NEAR(mechanism.motion(mechanism.entry).pin_turn.value, -pi / 2., 1e-14) << n;
  }
  const Mechanism sphere = spherical_geneva(7, 1.1, centre_distance);
  EXPECT_NEAR(sphere.motion(sphere.exit).pin_turn.value, pi / 2., 1e-12);
}

/// A spherical pin's spin about its own axis is the sum of the shares of both shafts.
TEST(PinTurn, OnASphereIsTheSpinOfBothShaftsAboutThePin) {
  for (const double shaft_angle : {0.3, 1.2, pi / 2., 2.5}) {
    const Mechanism mechanism = spherical_geneva(6, shaft_angle, centre_distance);
    const double cone = std::asin(std::sin(shaft_angle) * std::sin(pi / 6.));
    for (const double part : {-0.9, -0.4, 0., 0.6}) {
      const SlotMotion motion = mechanism.motion(part * mechanism.exit);
      EXPECT_NEAR(motion.pin_turn.first,
                  motion.wheel_angle.first * motion.friction_lever + std::cos(cone), 1e-12);
    }
  }
}

struct Reversal {
  int stations;
  double pin_ratio;  // Johnson's k2 = d/D
  double angle;      // on the driving wall, degrees
  double middle;     // slip at the line of centres over omega d/2
  double entry;      // slip at entry over omega r
};

class SlipOfJohnsonsWheels : public testing::TestWithParam<Reversal> {};

/// u' = omega r c sin(theta)/x and psi' = omega + phi' by hand.
TEST_P(SlipOfJohnsonsWheels, ReversesBeforeTheLineOfCentres) {
  const Reversal& row = GetParam();
  const double s = std::sin(pi / row.stations);
  const double d = row.pin_ratio * 2. * centre_distance * std::cos(pi / row.stations);
  const Mechanism mechanism = external_geneva(row.stations, centre_distance);
  const std::vector<SlipReversal> found = slip_reversals(mechanism, d);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].wall, Wall::driving);
  EXPECT_NEAR(found[0].driver_angle / degree, row.angle, 5.1e-5);
  EXPECT_EQ(found[1].wall, Wall::braking);
  EXPECT_NEAR(found[1].driver_angle, -found[0].driver_angle, 1e-13) << "the mirror image";
  const auto slip = [&](const double angle) {
    const SlotMotion motion = mechanism.motion(angle);
    return surface_speed(motion.slot_position, motion.pin_turn, d, Wall::driving);
  };
  EXPECT_NEAR(slip(0.) / (d / 2.), row.middle, 5.1e-6);
  EXPECT_NEAR(slip(0.) / (d / 2.), 1. / (1. - s), 1e-13);
  EXPECT_NEAR(slip(mechanism.entry) / (centre_distance * s), row.entry, 5.1e-7);
}

INSTANTIATE_TEST_SUITE_P(Table1, SlipOfJohnsonsWheels,
                         testing::Values(Reversal{3, 0.16, -4.7035, 7.46410, -0.907624},
                                         Reversal{4, 0.15, -8.1766, 3.41421, -0.850000},
                                         Reversal{5, 0.14, -10.7496, 2.42592, -0.807307},
                                         Reversal{6, 0.14, -13.6698, 2.00000, -0.757513},
                                         Reversal{7, 0.14, -16.5249, 1.76642, -0.709287},
                                         Reversal{8, 0.13, -17.9733, 1.61991, -0.686152}),
                         [](const testing::TestParamInfo<Reversal>& row) {
                           return std::to_string(row.param.stations) + "stations";
                         });

TEST(SlipReversals, AreWhereTheAxisTurnsBackWithoutDiameter) {
  for (const Bodies& bodies : every_mechanism()) {
    const auto found = slip_reversals(bodies.mechanism, 0.);
    ASSERT_EQ(found.size(), 2U) << bodies.name;
    EXPECT_EQ(found[0].driver_angle, found[1].driver_angle) << bodies.name;
    EXPECT_NEAR(bodies.mechanism.motion(found[0].driver_angle).slot_position.first, 0., 1e-14);
  }
}

/// No change of sign is missed and none is made up, whatever the mechanism.
TEST(SlipReversals, CutAnEngagementIntoStretchesOfOneSign) {
  for (const Bodies& bodies : every_mechanism()) {
    const Mechanism& mechanism = bodies.mechanism;
    const std::vector<SlipReversal> found = slip_reversals(mechanism, pin_diameter);
    for (const Wall wall : {Wall::driving, Wall::braking}) {
      std::vector<double> ends{mechanism.entry};
      for (const SlipReversal& reversal : found)
        if (reversal.wall == wall) ends.push_back(reversal.driver_angle);
      ends.push_back(mechanism.exit);
      double last_sign = 0.;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        ASSERT_LT(ends[i], ends[i + 1]) << bodies.name;
        double sign = 0.;
        for (int k = 1; k < 1000; ++k) {
          const SlotMotion motion = mechanism.motion(ends[i] + (ends[i + 1] - ends[i]) * k / 1000.);
          const double speed =
              surface_speed(motion.slot_position, motion.pin_turn, pin_diameter, wall);
          if (sign == 0.) sign = speed > 0. ? 1. : -1.;
          EXPECT_GT(speed * sign, 0.) << bodies.name << ", stretch " << i;
        }
        EXPECT_NE(sign, last_sign) << bodies.name;
        last_sign = sign;
      }
    }
  }
}

/// A link stops turning where its sprocket ends: the slip jumps there, and with a thick pin it
/// changes its sign by that jump.
TEST(SlipReversals, AreAtTheJointWhereAChainLinkStopsTurning) {
  const Mechanism mechanism =
      long_dwell_geneva(6, 0.04, 0.012, SprocketLine::across_line_of_centres);
  const double joint = mechanism.joints.front();
  const auto speed = [&](const double angle) {
    const SlotMotion motion = mechanism.motion(angle);
    return surface_speed(motion.slot_position, motion.pin_turn, 0.008, Wall::driving);
  };
  ASSERT_GT(speed(joint - 1e-9), 0.);
  ASSERT_LT(speed(joint + 1e-9), 0.);
  bool is_found = false;
  for (const SlipReversal& reversal : slip_reversals(mechanism, 0.008))
    if (reversal.wall == Wall::driving && reversal.driver_angle == joint) is_found = true;
  EXPECT_TRUE(is_found);
}

}  // namespace
}  // namespace geneva::loads
