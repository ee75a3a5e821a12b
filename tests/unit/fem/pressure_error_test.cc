#include "fem/adaptivity/pressure_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/adaptivity/lengthwise_pressure.h"

namespace geneva::fem {
namespace {

/// A mesh that has the contact zone finer than the one before, with nodes enough.
LevelRecord level(const double peak_pressure) {
  LevelRecord record{};
  record.peak_pressure = peak_pressure;
  record.refined = Refined::zone;
  record.halvings = 1;
  record.size_measure = 1.;
  record.nodes_across = record.active_nodes = 40;
  return record;
}

const ContactTraits free_contact{{true, false, false}, 0.3, 0.001, true, false, false};
const std::vector<LevelRecord> settling{level(1.05e6), level(1.01e6), level(1.e6)};

TEST(PressureError, IsThatOfZoneAndSurroundingsTogether) {
  const PressureError error = pressure_error<2>(settling, free_contact);
  EXPECT_LT(error.zone, 1.);
  EXPECT_EQ(error.total(), error_of(error.zone, error.surroundings));
  EXPECT_TRUE(error.is_of_peak());
}

TEST(PressureError, IsUnknownWhereEdgesAreUnevenOrOneMeshIsAll) {
  ContactTraits uneven = free_contact;
  uneven.is_uneven = true;
  EXPECT_EQ(pressure_error<2>(settling, uneven).zone, 1.);
  EXPECT_EQ(pressure_error<2>(settling, uneven).correction, 0.);
  EXPECT_EQ(pressure_error<2>({level(1e6)}, free_contact).total(), 1.);
}

TEST(PressureError, HasNoPartOfTheSurroundingsWhereTheyAreFineOrNothingDependsOnThem) {
  ContactTraits fine = free_contact;
  fine.surroundings_are_fine = true;
  ContactTraits held = free_contact;
  held.has_free_ends = false;
  EXPECT_EQ(pressure_error<2>(settling, fine).surroundings, 0.);
  EXPECT_EQ(pressure_error<2>(settling, held).surroundings, 0.);
  EXPECT_GT(pressure_error<2>(settling, free_contact).surroundings, 0.);
}

/// Under a force that is too great by a tenth, a fiftieth, ... the pressure of a line contact is
/// too great by half of that, and nothing else is wrong.
TEST(PressureError, IsThatOfTheForceWhereMovingSupportsPress) {
  std::vector<LevelRecord> history{level(1e6), level(1e6), level(1e6)};
  double energy_error = 0.2;
  for (LevelRecord& mesh : history) {
    mesh.energy_error = energy_error;
    mesh.peak_pressure *= std::sqrt(1. + force_excess(energy_error));
    energy_error /= 10.;
  }
  ContactTraits pressed = free_contact;
  pressed.error_by_nodes = 0.;
  pressed.force = {0.5, 0.};
  const PressureError error = pressure_error<2>(history, pressed);
  EXPECT_NEAR((1. + error.correction) * history.back().peak_pressure, 1e6, 1e-3);
  EXPECT_NEAR(error.zone, 0., 1e-12);
  const PressureError given = pressure_error<2>({level(1e6), level(1e6), level(1e6)}, pressed);
  EXPECT_NEAR(error.surroundings, error_of(given.surroundings, 0.5 * force_doubt(0.002)), 1e-12);

  pressed.has_free_ends = false;  // no cells around count, and the zone's have to be finer
  const PressureError held = pressure_error<2>(history, pressed);
  EXPECT_EQ(held.surroundings, 0.);
  EXPECT_NEAR(held.zone, 0.5 * force_doubt(0.002), 1e-12);
}

TEST(ForceOfPeak, HasHertzsPowersAndOneWhereTheContactCannotGrow) {
  EXPECT_EQ(force_of_peak({false, false, true}).power, 1. / 2.);
  EXPECT_EQ(force_of_peak({true, false, true}).power, 1. / 3.);
  EXPECT_EQ(force_of_peak({false, false, false}).power, 1.);
  const ForcePower of_flat = force_of_peak({false, true, true});
  EXPECT_LE(of_flat.power - of_flat.doubt, 1. / 2.);
  EXPECT_GE(of_flat.power + of_flat.doubt, 1.);
}

ContactNode<3> node(const double z, const double pressure) {
  ContactNode<3> result{};
  result.position = {0., 0., z};
  result.pressure = pressure;
  return result;
}

TEST(LengthwisePressure, IsTheMaximumInTheMiddleHalfAndAtBothEnds) {
  ContactResult<3> contact{};
  contact.nodes = {node(-2., 7.), node(-1.5, 9.), node(-1., 4.),
                   node(0., 3.),  node(1., 5.),   node(2., 6.)};
  const LengthwisePressure whole = lengthwise_pressure(contact, {});
  EXPECT_EQ(whole.middle, 5.);
  EXPECT_EQ(whole.end, 7.);
  // Beyond a plane of symmetry at -2 the half length is 4: all up to z = 0 is in the middle.
  const LengthwisePressure half = lengthwise_pressure(contact, -2.);
  EXPECT_EQ(half.middle, 9.);
  EXPECT_EQ(half.end, 6.);
}

}  // namespace
}  // namespace geneva::fem
