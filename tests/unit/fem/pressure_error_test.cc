#include "fem/adaptivity/pressure_error.h"

#include <gtest/gtest.h>

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
