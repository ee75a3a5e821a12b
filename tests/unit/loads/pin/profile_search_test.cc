#include "loads/pin/profile_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "loads/pin/load_evenness.h"

namespace geneva::loads::test {
namespace {

constexpr double modulus = 207e9;  // [Pa]
constexpr double half = 0.01;      // of the wheel's thickness [m]

PinLine steel_pin(const double upper_end, const bool held_at_both_ends) {
  PinLine pin{};
  pin.pin = {modulus, 0.3};
  pin.wheel = pin.pin;
  pin.radius = 0.008;
  pin.relative_radius = pin.radius;
  pin.hold = held_at_both_ends ? PinHold::both_ends : PinHold::one_end;
  pin.clearance.wall_half = half;
  pin.clearance.lower_end = held_at_both_ends ? -upper_end : -0.014;
  pin.clearance.upper_end = upper_end;
  return pin;
}

/// The crown of a pin under a force.
ProfileDuty crown_of(const PinLine& pin, const double force, std::vector<double> tilts) {
  return {pin, [](const double size) { return Crown{size}; }, 5., 0.05, std::move(tilts), force};
}

double pressure_of(const ProfileDuty& duty, const double line_load) {
  return std::sqrt(line_load * contact_modulus(duty.pin.pin, duty.pin.wheel) /
                   (pi * duty.pin.relative_radius));
}

TEST(LoadEvenness, OfAnEvenLoadIsOne) {
  PinLine pin = steel_pin(0.03, false);
  PinLineContact contact;
  for (int i = 0; i < 10; ++i)
    contact.sections.push_back({-half + (i + 0.5) * half / 5., half / 5., 4.});
  contact.peak_line_load = 4.;
  contact.begin = -half;
  contact.end = half;
  const LoadEvenness load = load_evenness(pin, contact);
  EXPECT_NEAR(load.ratio(), 1., 1e-12);
  EXPECT_NEAR(load.even, 4., 1e-12);
}

TEST(LoadEvenness, CountsAPartlyCoveredSectionInPart) {
  PinLine pin = steel_pin(0.03, false);
  PinLineContact contact;
  contact.sections = {{-half / 2., half, 1.},
                      {half / 2. - 0.0001, half - 0.0002, 0.},
                      {half - 0.0001, 0.0002, 50.}};
  contact.peak_line_load = 50.;
  contact.begin = -half;
  contact.end = half;
  // a twentieth of the length is 1 mm, of which 0.2 mm carry 50 N/m
  const LoadEvenness load = load_evenness(pin, contact);
  EXPECT_NEAR(load.maximum, 10., 1e-9);
  EXPECT_NEAR(load.place, half - 0.0005, 1e-12);
}

TEST(ProfileSearch, FindsTheLeastOfWhatItsNeighboursHave) {
  const ProfileDuty duty = crown_of(steel_pin(0.014, false), 2000., {0.});
  const ProfileSearch found = find_profile(duty);
  for (const double factor : {0.8, 1.25}) {
    const PinLine pin = pin_of(duty, factor * found.best.size, 0.);
    EXPECT_GT(load_evenness(pin, pin_line_contact(pin, duty.force, 1e-3)).maximum,
              found.best.line_load);
  }
  for (const ProfileTrial& trial : found.trials) EXPECT_GE(trial.line_load, found.best.line_load);
}

TEST(ProfileSearch, OfATiltEitherWayIsTheSameOnASymmetricPin) {
  const PinLine pin = steel_pin(0.014, true);
  const double tilt = 3e-4;
  const ProfileSearch one = find_profile(crown_of(pin, 2000., {tilt}));
  const ProfileSearch other = find_profile(crown_of(pin, 2000., {-tilt}));
  EXPECT_NEAR(one.best.size / other.best.size, 1., 0.02) << "the minimum is flat";
  EXPECT_NEAR(one.best.line_load / other.best.line_load, 1., 1e-4);
}

TEST(ProfileSearch, ForAllTiltsIsThatForTheWorst) {
  const PinLine pin = steel_pin(0.02, false);
  const double tilt = 4e-4;
  const ProfileSearch both = find_profile(crown_of(pin, 2000., {-tilt, tilt}));
  const ProfileSearch worst = find_profile(crown_of(pin, 2000., {both.best.worst_tilt}));
  const ProfileSearch level = find_profile(crown_of(pin, 2000., {0.}));
  EXPECT_GE(both.best.line_load, worst.best.line_load * (1. - 1e-3));
  EXPECT_GT(both.best.line_load, level.best.line_load);
  EXPECT_LT(both.best.size, level.best.size) << "a pin that may lean needs more crown";
  EXPECT_LT(both.best.worst_tilt, 0.) << "bending leans the root's end towards the wall already";
}

TEST(ProfileSearch, StaysAboveTheLeastSizeAllowed) {
  ProfileDuty duty = crown_of(steel_pin(0.014, false), 2000., {0.});
  const double free = find_profile(duty).best.size;
  duty.least_size = 3. * free;
  const ProfileSearch found = find_profile(duty);
  for (const ProfileTrial& trial : found.trials)
    EXPECT_GE(trial.size, duty.least_size * (1. - 1e-12));
  EXPECT_LT(found.best.size, 1.1 * duty.least_size);
}

TEST(ProfileMap, HasTheSizeFoundInItsMiddleAndRisesToBothSides) {
  const ProfileDuty duty = crown_of(steel_pin(0.014, false), 2000., {-2e-4, 2e-4});
  const ProfileSearch found = find_profile(duty);
  const ProfileMap map = map_around(duty, found.best.size);
  ASSERT_EQ(map.tilts.size(), 9U);
  ASSERT_EQ(map.pressures.size(), map.tilts.size());
  EXPECT_EQ(map.tilts.front(), -2e-4);
  EXPECT_EQ(map.tilts.back(), 2e-4);
  std::vector<double> worst(map.sizes.size(), 0.);
  for (const auto& row : map.pressures) {
    ASSERT_EQ(row.size(), map.sizes.size());
    for (std::size_t i = 0; i < row.size(); ++i) worst[i] = std::max(worst[i], row[i]);
  }
  const auto least = std::min_element(worst.begin(), worst.end());
  EXPECT_NEAR(map.sizes[static_cast<std::size_t>(least - worst.begin())] / found.best.size, 1.,
              1e-12);
  EXPECT_NEAR(*least / pressure_of(duty, found.best.line_load), 1., 1e-9);
}

TEST(ProfileMap, OfOneTiltHasOneLine) {
  const ProfileDuty duty = crown_of(steel_pin(0.014, false), 2000., {1e-4});
  EXPECT_EQ(map_around(duty, 5.).tilts, std::vector<double>{1e-4});
}

}  // namespace
}  // namespace geneva::loads::test
