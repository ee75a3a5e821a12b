#include "fem/adaptivity/error_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "fem/contact/result.h"
#include "fem/contact/zone.h"
#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

/// Pressures that rise in the active rows to a peak in the middle, or in a given row.
ContactState rising(const std::vector<bool>& active, const double peak,
                    const std::optional<std::size_t> at = {}) {
  const std::size_t top = at.value_or(active.size() / 2);
  ContactState state{};
  for (std::size_t i = 0; i < active.size(); ++i) {
    const double distance = i > top ? static_cast<double>(i - top) : static_cast<double>(top - i);
    state.pressure.push_back(active[i] ? peak * (1. - 1e-3 * distance) : 0.);
  }
  return state;
}

constexpr EndTraits in_plane{false, false};

TEST(ErrorEstimate, KnowsThatAFreeEndLiesSomewhereOnAnEdge) {
  const std::vector<bool> free_ends{false, true, true, true, true, true, true, true, false};
  const std::vector<bool> one_end{true, true, true, true, false};
  const std::vector<bool> no_end(8, true);
  const double with_two = end_error<2>({with_active(free_ends)}, {rising(free_ends, 1.)}, in_plane);
  EXPECT_GT(with_two, 0.4 / 49.) << "of the order 1/N^2 with 7 nodes";
  EXPECT_NEAR(end_error<2>({with_active(one_end)}, {rising(one_end, 1., 0)}, in_plane), with_two,
              1e-15)
      << "half of that contact";
  EXPECT_NEAR(end_error<2>({with_active(one_end)}, {rising(one_end, 1., 0)}, {true, false}),
              with_two * 0.8 / 0.47 * 49. / 16., 1e-15)
      << "on an axis";
  EXPECT_NEAR(end_error<2>({with_active(free_ends)}, {rising(free_ends, 1.)}, {false, true}),
              with_two * 0.12 / 0.47, 1e-15)
      << "freed from the nodes";
  const std::vector<bool> few{false, true, true, true, true, true, false};
  EXPECT_EQ(end_error<2>({with_active(few)}, {rising(few, 1.)}, {false, true}),
            end_error<2>({with_active(few)}, {rising(few, 1.)}, in_plane))
      << "of too few";
  EXPECT_EQ(end_error<2>({with_active(no_end)}, {rising(no_end, 1.)}, in_plane), 0.);
  EXPECT_FALSE(has_free_ends<2>({with_active(no_end)}));
  EXPECT_TRUE(has_free_ends<2>({with_active(one_end)}));
}

TEST(ErrorEstimate, CountsTheNodesBetweenAFreeEndAndThePeak) {
  std::vector<bool> active(42, true);
  active.front() = active.back() = false;
  const std::vector<bool> seven{false, true, true, true, true, true, true, true, false};
  const double of_seven = end_error<2>({with_active(seven)}, {rising(seven, 1.)}, in_plane);
  EXPECT_NEAR(end_error<2>({with_active(active)}, {rising(active, 1., 4)}, in_plane), of_seven,
              1e-15);
  EXPECT_NEAR(end_error<2>({with_active(active)}, {rising(active, 1., 37)}, in_plane), of_seven,
              1e-15);
  ContactInterface<2> interface = with_active(active);
  const auto at = [&](const std::size_t i) { return interface.source.nodes[i].arc_length; };
  interface.smooth = {{at(9), at(30)}};
  EXPECT_NEAR(end_error<2>({interface}, {rising(active, 1., 4)}, in_plane), of_seven, 1e-15)
      << "and not those of a smooth middle";
}

TEST(ErrorEstimate, TellsAPeakBesideAnEndFromOneInTheMiddle) {
  std::vector<bool> active(42, true);
  active.front() = active.back() = false;
  const std::vector<bool> all_open(4, false);
  const std::vector<bool> half{true, true, true, true, true, true, false};
  const auto is_beside_end = [&](const std::size_t peak) {
    return peaks_beside_end<2>({with_active(all_open), with_active(active)},
                               {rising(all_open, 0.), rising(active, 1., peak)});
  };
  EXPECT_TRUE(is_beside_end(5));
  EXPECT_TRUE(is_beside_end(36));
  EXPECT_FALSE(is_beside_end(14));
  EXPECT_FALSE(is_beside_end(20));
  EXPECT_FALSE(peaks_beside_end<2>({with_active(half)}, {rising(half, 1., 0)}))
      << "half of a contact with the peak on the plane of symmetry";
  EXPECT_FALSE(peaks_beside_end<2>({with_active(active), with_active(half)},
                                   {rising(active, 1., 5), rising(half, 2., 0)}))
      << "the pair with the maximum pressure decides";
}

TEST(ErrorEstimate, OfALoneNodeBeyondTheContactCountsLittle) {
  const std::vector<bool> active{false, true, false, true, true, true, true, true, true, false};
  ContactState state = rising(active, 1.);
  state.pressure[1] = 0.01;
  EXPECT_LT(end_error<2>({with_active(active)}, {state}, in_plane), 0.1);
}

TEST(ErrorEstimate, OfSeveralPairsCountsEachAsItsPeakAndNotOpenOnes) {
  const std::vector<bool> eight{false, true, true, true, true, true, true, true, true, false};
  const std::vector<bool> two{false, true, true, false};
  const std::vector<bool> all_open(4, false);
  const double of_eight = end_error<2>({with_active(eight)}, {rising(eight, 1.)}, in_plane);
  const double of_two = end_error<2>({with_active(two)}, {rising(two, 1.)}, in_plane);
  EXPECT_DOUBLE_EQ(end_error<2>({with_active(eight), with_active(all_open)},
                                {rising(eight, 3.), rising(all_open, 0.)}, in_plane),
                   of_eight);
  EXPECT_DOUBLE_EQ(end_error<2>({with_active(eight), with_active(two)},
                                {rising(eight, 4.), rising(two, 2.)}, in_plane),
                   of_two / 2.);
}

std::vector<LevelRecord> history_of(const std::vector<double>& peaks, const unsigned int nodes) {
  std::vector<LevelRecord> history;
  for (const double peak : peaks) {
    LevelRecord record{};
    record.peak_pressure = peak;
    record.nodes_across = nodes;
    record.active_nodes = nodes;
    record.refined = history.empty() ? Refined::nothing : Refined::zone;
    history.push_back(record);
  }
  return history;
}

TEST(SmoothParts, AreFoundWhereAPressureHasNoBend) {
  constexpr unsigned int count = 201;
  ContactInterface<2> interface = flat_pair(count - 1);
  interface.status.assign(count, slip);
  ContactState state{std::vector<double>(count, 0.5), {}, 0.};
  for (const std::size_t i : {1U, 199U}) state.pressure[i] = 1.;
  const ArcIntervals smooth = smooth_intervals(interface, state, 1e-3);
  ASSERT_EQ(smooth.size(), 1U);
  EXPECT_NEAR((smooth[0].second - smooth[0].first) / interface.source.length, 178. / 200., 1e-12);
  interface.smooth = smooth;
  const std::vector<bool> zone = zone_rows(interface);
  EXPECT_EQ(std::count(zone.begin(), zone.end(), true), 22);
  EXPECT_EQ(zone_intervals(interface).size(), 2U);
}

TEST(SmoothParts, AreNoneInAContactThatIsSmoothOrBentAllOver) {
  constexpr unsigned int count = 201;
  ContactInterface<2> interface = flat_pair(count - 1);
  interface.status.assign(count, slip);
  ContactState state{std::vector<double>(count, 1.), {}, 0.};
  EXPECT_TRUE(smooth_intervals(interface, state, 1e-3).empty());
  for (std::size_t i = 0; i < count; i += 10) state.pressure[i] = 0.9;
  EXPECT_TRUE(smooth_intervals(interface, state, 1e-3).empty());
}

TEST(UnboundedPressure, GrowsOnThreeMeshesInARow) {
  EXPECT_TRUE(grows_without_bound(history_of({1., 1.2, 1.4, 1.7}, 20)));
  EXPECT_TRUE(grows_without_bound(history_of({9., 1., 1.2, 1.4, 1.7}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1.2, 1.4, 1.7}, 20))) << "too few meshes to say so";
  EXPECT_FALSE(grows_without_bound(history_of({1., 1.2, 1.4, 1.45}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1., 1.2, 1.1, 1.3}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1., 2., 4., 8.}, 3)))
      << "a contact that is not resolved gets narrower with the mesh";
  EXPECT_FALSE(grows_without_bound({}));
}

TEST(UnboundedPressure, IsExpectedAtAnEndOrACornerOnly) {
  constexpr std::size_t count = 41;
  ContactInterface<2> interface = flat_pair(count - 1);
  const auto peaks_at = [&](const std::size_t row) {
    ContactState state{std::vector<double>(count, 0.5), {}, 0.};
    state.pressure[row] = 1.;
    return peaks_at_corner(interface, state);
  };
  for (const std::size_t row : {0U, 3U, 37U, 40U}) EXPECT_TRUE(peaks_at(row)) << row;
  for (const std::size_t row : {6U, 20U, 34U}) EXPECT_FALSE(peaks_at(row)) << row;
  // a kink of the target
  std::vector<dealii::Point<2>> roof{{1.2, 0.}, {0.5, 0.01}, {-0.2, 0.}};
  interface.target = straight_surface(roof);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  ASSERT_EQ(interface.rows.size(), count);
  EXPECT_TRUE(peaks_at(20));
}

TEST(UnboundedPressure, IsNotTakenFromMeshesThatOnlyRefineTheSurroundings) {
  auto history = history_of({1., 1.2, 1.4, 1.7}, 20);
  history[2].refined = Refined::surroundings;
  EXPECT_FALSE(grows_without_bound(history));
}

TEST(NoProgress, IsSeenWhereNeitherNodesNorPressureChangeOnThreeMeshes) {
  EXPECT_TRUE(stands_still(history_of({4., 1., 1., 1., 1.}, 1)));
  EXPECT_FALSE(stands_still(history_of({1., 1., 1.}, 1))) << "two meshes";
  EXPECT_FALSE(stands_still(history_of({1., 2., 4., 8.}, 1))) << "a load on one node";
  auto growing = history_of({1., 1., 1., 1.}, 5);
  for (std::size_t i = 0; i < growing.size(); ++i) growing[i].active_nodes <<= i;
  EXPECT_FALSE(stands_still(growing)) << "a flat face in contact";
}

constexpr Convergence forces_given{true, false, false};

TEST(Extrapolation, FindsBothPartsOfAnErrorOfSecondOrder) {
  // 1 + 0.08 h^2 + 0.05 s with the cells' size h in the zone and the size measure s around it
  const auto value = [](const double h, const double s) { return 1. + 0.08 * h * h + 0.05 * s; };
  const std::vector<MeshValue> values{{value(1., 1.), Refined::nothing, 0, 1.},
                                      {value(0.5, 1.), Refined::zone, 1, 1.},
                                      {value(0.25, 1.), Refined::zone, 1, 1.},
                                      {value(0.25, 0.25), Refined::surroundings, 0, 0.25}};
  const Extrapolation found = extrapolate(values, 0.2, forces_given);
  EXPECT_NEAR(found.correction, -0.75 * 0.05 * 0.25, 2e-4);
  EXPECT_NEAR(found.surroundings_error, 0.3 * 0.05 * 0.25, 2e-4);
  EXPECT_NEAR(found.zone_error, 0.08 / 16., 2e-4);
}

TEST(Extrapolation, OfFirstOrderLeavesAsMuchAsTheLastChange) {
  const std::vector<MeshValue> values{
      {1.4, Refined::nothing, 0, 1.}, {1.2, Refined::zone, 1, 1.}, {1.1, Refined::zone, 1, 1.}};
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).zone_error, 0.1 / 1.1, 1e-12);
}

TEST(Extrapolation, KeepsAShareOfTheZonesPartInThePlane) {
  const std::vector<MeshValue> settling{
      {1.4, Refined::nothing, 0, 1.}, {1.2, Refined::zone, 1, 1.}, {1.1, Refined::zone, 1, 1.}};
  const std::vector<MeshValue> scattered{
      {1.4, Refined::nothing, 0, 1.}, {1., Refined::zone, 1, 1.}, {1.1, Refined::zone, 1, 1.}};
  constexpr Convergence of_peak_in_plane{true, false, false, true, false};
  constexpr Convergence freed_from_nodes{true, false, false, true, true};
  const auto left = [](const std::vector<MeshValue>& values, const Convergence& convergence) {
    return extrapolate(values, 0.2, convergence).zone_error;
  };
  EXPECT_NEAR(left(settling, of_peak_in_plane), 0.7 * left(settling, forces_given), 1e-12);
  EXPECT_EQ(left(scattered, of_peak_in_plane), left(scattered, forces_given));
  EXPECT_NEAR(left(settling, freed_from_nodes), 0.2 * left(settling, forces_given), 1e-12);
  EXPECT_NEAR(left(scattered, freed_from_nodes), 0.2 * left(scattered, forces_given), 1e-12);
}

TEST(Extrapolation, LeavesALineContactSomeDoubtWhereCellsAroundChangedNothing) {
  const std::vector<MeshValue> values{{1., Refined::nothing, 0, 4.},
                                      {1., Refined::surroundings, 0, 1.}};
  const auto doubt = [&](const double grading) {
    return extrapolate(values, grading, {true, false, false, true, true}).surroundings_error;
  };
  EXPECT_GT(doubt(0.2), 0.);
  EXPECT_NEAR(doubt(0.2), 4. * doubt(0.1), 1e-15) << "of second order in the cells' size";
  EXPECT_EQ(extrapolate(values, 0.2, forces_given).surroundings_error, 0.) << "was not measured";
}

TEST(Extrapolation, DoesNotTrustTwoMeshesThatAgree) {
  const std::vector<MeshValue> values{
      {1.6, Refined::nothing, 0, 1.}, {1.2, Refined::zone, 1, 1.}, {1.2, Refined::zone, 1, 1.}};
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).zone_error, 0.4 / 1.2 / 3. / 4., 1e-12)
      << "what the change before leaves at second order";
}

TEST(Extrapolation, TakesTheMiddleOfTheFirstOrderWhereTheForceDependsOnTheCellsToo) {
  const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                      {1.1, Refined::zone, 1, 1.},
                                      {1.02, Refined::surroundings, 0, 0.25}};
  const double change = -0.08 / 1.02;
  const Extrapolation found = extrapolate(values, 0.2, {false, false, false});
  EXPECT_NEAR(found.correction, change / 2., 1e-12) << "an error of stiffness is halved at most";
  EXPECT_NEAR(found.surroundings_error, -change / 2., 1e-12);
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).correction, 0.75 * change / 3., 1e-12);
}

TEST(Extrapolation, OfALineContactIsPulledToWhatOthersHaveShown) {
  const auto correction = [](const double before, const double grading, const double nu = 0.3) {
    const std::vector<MeshValue> values{{before, Refined::nothing, 0, 4.},
                                        {1., Refined::surroundings, 0, 1.}};
    return extrapolate(values, grading, {true, false, false, true, true, nu}).correction;
  };
  EXPECT_LT(correction(1., 0.2), 0.) << "coarse cells are stiff, also where no change shows it";
  EXPECT_NEAR(correction(1., 0.2), 4. * correction(1., 0.1), 1e-15);
  const double change = 1e-3;
  EXPECT_NEAR(correction(1. + change, 0.2) - correction(1., 0.2), -0.4 * change / 3., 1e-12);
  EXPECT_LT(correction(1., 0.2, 0.48), 1.5 * correction(1., 0.2, 0.)) << "more of a stiff volume";
}

TEST(Extrapolation, TakesNoMoreFromAFallOfTheMeasureThanTheEnergysErrorFell) {
  const auto left_after = [](const double energy_before) {
    const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 8., energy_before},
                                        {1., Refined::surroundings, 0, 1., 0.01}};
    return -extrapolate(values, 0.2, forces_given).correction / 0.75;
  };
  EXPECT_NEAR(left_after(0.025), 0.1 / 1.5, 1e-12);
  EXPECT_NEAR(left_after(0.08), 0.1 / 3., 1e-12) << "a quarter is the most that is left";
  EXPECT_NEAR(left_after(0.01), 0.1 / 0.5, 1e-12);
}

TEST(ErrorEstimate, AsksForTwoMeshesOfTheZoneWithEnoughNodesInThePlane) {
  std::vector<LevelRecord> history = history_of({1., 1.1, 1.12}, 3);
  for (LevelRecord& level : history) level.refined = Refined::zone;
  const auto with_nodes = [&](const std::vector<unsigned int>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) history[i].nodes_across = nodes[i];
    return history;
  };
  EXPECT_FALSE(shows_zone_error<2>(with_nodes({3, 5, 10})));
  EXPECT_TRUE(shows_zone_error<3>(with_nodes({3, 5, 10})));
  EXPECT_TRUE(shows_zone_error<2>(with_nodes({3, 6, 11})));
  EXPECT_FALSE(shows_zone_error<3>(with_nodes({6, 6, 5})));
  EXPECT_EQ(resolved_values(with_nodes({3, 2, 5}), &LevelRecord::peak_pressure, {}).size(), 1U);
  EXPECT_EQ(resolved_values(with_nodes({3, 5, 10}), &LevelRecord::peak_pressure, {}).size(), 3U);
}

TEST(Extrapolation, TakesNoMoreFromAFallOfTheMeasureThanHalvedCellsCanGive) {
  const auto left_with = [](const double measure) {
    const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                        {1.1, Refined::zone, 1, 1.},
                                        {1.02, Refined::surroundings, 0, measure}};
    return extrapolate(values, 0.2, forces_given);
  };
  EXPECT_NEAR(left_with(0.01).correction, left_with(0.25).correction, 1e-12);
  EXPECT_NEAR(left_with(0.25).correction, -0.75 * 0.08 / 1.02 / 3., 1e-12);
  EXPECT_EQ(left_with(0.8).correction, 0.) << "hardly any of the error is seen";
  EXPECT_NEAR(left_with(0.8).surroundings_error, 0.35 * 0.04, 1e-12) << "the worst that was seen";
}

TEST(Extrapolation, LeavesAllInDoubtWhereThePressurePeaksBesideAnEnd) {
  const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                      {1.1, Refined::zone, 1, 1.},
                                      {1.02, Refined::surroundings, 0, 0.25}};
  const Extrapolation found = extrapolate(values, 0.2, {true, false, true});
  EXPECT_NEAR(found.correction, -0.08 / 1.02 / 6., 1e-12);
  EXPECT_NEAR(found.surroundings_error, 0.08 / 1.02 / 3., 1e-12);
}

TEST(ErrorEstimate, TakesItsPartsAsIndependent) {
  EXPECT_DOUBLE_EQ(error_of(0.03, 0.04), 0.05);
  EXPECT_EQ(error_of(1., 0.5), 1.);
}

TEST(Extrapolation, CorrectsTheZoneOnAnAxisOfRevolution) {
  const auto value = [](const double h) { return 1. - 0.08 * h * h; };
  const std::vector<MeshValue> values{{value(1.), Refined::nothing, 0, 1.},
                                      {value(0.5), Refined::zone, 1, 1.},
                                      {value(0.25), Refined::zone, 1, 1.}};
  const Extrapolation found = extrapolate(values, 0.2, {true, true, false});
  EXPECT_NEAR(values.back().value * (1. + found.correction), 1., 1e-12);
  EXPECT_EQ(extrapolate(values, 0.2, forces_given).correction, 0.);
  EXPECT_EQ(extrapolate(values, 0.2, {false, true, false}).correction, 0.)
      << "a force that still changes";
}

TEST(Extrapolation, SaysNothingSmallOfCellsThatWereNeverRefined) {
  EXPECT_EQ(extrapolate({{1., Refined::nothing, 0, 1.}}, 0.5, forces_given).zone_error, 1.);
  EXPECT_GT(
      extrapolate({{1., Refined::nothing, 0, 1.}, {1., Refined::zone, 1, 1.}}, 0.5, forces_given)
          .surroundings_error,
      0.05);
}

TEST(ErrorEstimate, GradingGetsFinerWithTheAccuracyAndStaysInItsRange) {
  EXPECT_LE(first_grading<2>(1.), 0.5);
  EXPECT_LE(first_grading<3>(1.), 0.5);
  EXPECT_GT(first_grading<2>(1e-6), 0.);
  EXPECT_NEAR(first_grading<2>(1e-4) / first_grading<2>(1e-6), 10., 1e-12)
      << "an error of second order";
}

}  // namespace
}  // namespace geneva::fem::test
