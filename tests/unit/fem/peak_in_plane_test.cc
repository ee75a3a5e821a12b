#include "fem/contact/peak_in_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fem/contact/zone.h"
#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

/// A contact of nodes at x = i h, open where the pressure is 0.
ContactResult<2> contact_of(const std::vector<double>& pressures, const double h) {
  ContactResult<2> contact{};
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    ContactNode<2> node{};
    node.arc_length = static_cast<double>(i) * h;
    node.pressure = pressures[i];
    node.tributary = h;
    node.status = pressures[i] > 0. ? NodeStatus::slip : NodeStatus::open;
    contact.nodes.push_back(node);
  }
  contact.peak_pressure = fitted_peak(contact.nodes).pressure;
  return contact;
}

/// Integral of sqrt(1 - x^2) from 0.
double area_of_circle(const double x) { return 0.5 * (x * std::sqrt(1. - x * x) + std::asin(x)); }
/// Integral of x sqrt(1 - x^2) from 0.
double moment_of_circle(const double x) { return (1. - std::pow(1. - x * x, 1.5)) / 3.; }

/// Mean of Hertz's pressure over the hat function around x, of half-width h, within the contact.
double mean_over_hat(const double x, const double h) {
  const auto half = [&](const double other, const double sign) {
    const double area = area_of_circle(other) - area_of_circle(x);
    const double moment = moment_of_circle(other) - moment_of_circle(x);
    return sign * ((1. + sign * x / h) * area - sign * moment / h);
  };
  return (half(x + h, 1.) + half(x - h, -1.)) / h;
}

TEST(FittedPeak, FreesHertzPressureFromTheMeanOverTheNodesEdges) {
  for (const double h : {0.05, 0.1}) {
    std::vector<double> pressures;
    const int n = static_cast<int>(0.75 / h);
    for (int i = -n; i <= n; ++i) pressures.push_back(mean_over_hat((i + 0.3) * h, h));
    const FittedPeak peak = fitted_peak(contact_of(pressures, h).nodes);
    EXPECT_NEAR(peak.averaging, h * h / 12., 0.03 * h * h / 12.);
    EXPECT_NEAR(peak.pressure * (1. + peak.averaging), 1., 0.05 * h * h / 12.);
  }
}

TEST(FittedPeak, OfFewNodesTakesTheCurvatureThatTheyShow) {
  const double h = 0.4;
  std::vector<double> pressures{0.};
  for (int i = -1; i <= 1; ++i) pressures.push_back(1. - 0.5 * std::pow(i * h, 2));
  pressures.push_back(0.);
  const FittedPeak peak = fitted_peak(contact_of(pressures, h).nodes);
  EXPECT_EQ(peak.pressure, 1.);
  EXPECT_NEAR(peak.averaging, h * h / 12., 1e-14);
}

TEST(FittedPeak, TellsTheScatterOfItsNodes) {
  const auto with_scatter = [](const double scatter) {
    std::vector<double> pressures;
    for (int i = -60; i <= 60; ++i)
      pressures.push_back(std::sqrt(1. - std::pow(i / 100., 2)) *
                          (1. + (i % 2 == 0 ? scatter : -scatter)));
    return fitted_peak(contact_of(pressures, 0.01).nodes).scatter;
  };
  EXPECT_NEAR(with_scatter(0.), 0., 1e-14);
  const double quantile = 1.989;            // Student's, of 84 degrees of freedom
  const double square = std::pow(0.43, 2);  // of where nine tenths are
  const double mean = 1. - 2. / 3. * square + square * square / 5.;  // of p^4
  EXPECT_NEAR(with_scatter(1e-3), quantile * 1e-3 * std::sqrt(mean / 84.), 1e-6)
      << "of 87 nodes above nine tenths, and 3 coefficients";
}

/// Pressures with a top of 1 in the middle and given ones at the ends, n nodes in all.
std::vector<double> with_ends(const std::size_t n, const double first, const double last) {
  std::vector<double> pressures(n + 2, 0.9);
  pressures.front() = pressures.back() = 0.;
  pressures[1 + n / 2] = 1.;
  pressures[1] = first;
  pressures[n] = last;
  return pressures;
}

TEST(FreeEnds, RaiseThePeakByTheSquareOfHowFarTheyAreOff) {
  constexpr std::size_t n = 25;
  const double about_to_follow = 1.65 / std::sqrt(n);
  const auto share = [&](const double first, const double last) {
    return share_of_free_ends(contact_of(with_ends(n, first, last), 0.1)).share * n * n;
  };
  EXPECT_NEAR(share(about_to_follow / 2., about_to_follow / 2.), 0., 1e-14) << "where they belong";
  EXPECT_NEAR(share(1e-12, 1e-12), 0.5, 1e-10) << "half an edge out";
  EXPECT_NEAR(share(about_to_follow, about_to_follow / 2.), 0.25, 1e-12) << "half an edge in";
  EXPECT_NEAR(share(2. * about_to_follow, 2. * about_to_follow), 0.5, 1e-12) << "no farther";
}

TEST(FreeEnds, CountTwiceWhereHalfOfTheContactIsModelled) {
  constexpr std::size_t n = 25;
  const std::vector<double> whole = with_ends(n, 0.05, 0.05);
  ContactResult<2> half = contact_of({whole.begin() + 1 + n / 2, whole.end()}, 0.1);
  EXPECT_EQ(share_of_free_ends(half).share, 0.) << "unless it ends at a plane of symmetry";
  half.symmetric = true;
  EXPECT_NEAR(share_of_free_ends(half).share, share_of_free_ends(contact_of(whole, 0.1)).share,
              1e-15);
}

TEST(FreeEnds, SayNothingWhereThePressurePeaksBesideOneOrNowhere) {
  std::vector<double> pressures = with_ends(24, 0.01, 0.01);
  std::swap(pressures[5], *std::max_element(pressures.begin(), pressures.end()));
  EXPECT_EQ(share_of_free_ends(contact_of(pressures, 0.1)).share, 0.);
  EXPECT_EQ(share_of_free_ends(contact_of(std::vector<double>(9, 0.), 0.1)).share, 0.);
  EXPECT_EQ(share_of_free_ends(contact_of(std::vector<double>(9, 1.), 0.1)).share, 0.);
}

TEST(TargetEdges, RaiseThePeakByTheirSquareOverTheSourcesOnlyInACompliantBody) {
  constexpr std::size_t n = 25;
  const std::vector<double> whole_pressures = with_ends(n, 0.05, 0.05);
  const ContactResult<2> whole = contact_of(whole_pressures, 0.1);
  const auto share = [&](const double ratio, const double of_compliance) {
    return n * n / 0.2 * share_of_target(whole, {ratio, of_compliance});
  };
  EXPECT_NEAR(share(1., 0.5), 0., 1e-15);
  EXPECT_NEAR(share(1.5, 0.4), 0.5, 1e-14);
  EXPECT_LT(share(0.9, 0.5), 0.);
  EXPECT_EQ(share(1.5, 0.), 0.) << "of a rigid body they do not count";
  ContactResult<2> half =
      contact_of({whole_pressures.begin() + 1 + n / 2, whole_pressures.end()}, 0.1);
  half.symmetric = true;
  EXPECT_NEAR(share_of_target(half, {1.5, 0.4}), share_of_target(whole, {1.5, 0.4}), 1e-16);
  std::vector<double> beside_end = with_ends(24, 0.01, 0.01);
  std::swap(beside_end[5], *std::max_element(beside_end.begin(), beside_end.end()));
  EXPECT_EQ(share_of_target(contact_of(beside_end, 0.1), {1.5, 0.4}), 0.);
}

TEST(TargetEdges, AreComparedWhereTheContactIsClosed) {
  std::vector<double> source, target;
  for (int i = 0; i <= 16; ++i) source.push_back(i / 16.);
  for (int i = 0; i <= 8; ++i) target.push_back(i / 16.);
  for (int i = 1; i <= 4; ++i) target.push_back(0.5 + i / 8.);
  ContactInterface<2> interface;
  interface.source = underside(source, 0.);
  interface.target = upper_side(target);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status.assign(interface.rows.size(), NodeStatus::open);
  EXPECT_EQ(ratio_of_edges(interface), 1.) << "nowhere";
  for (std::size_t i = 10; i < 15; ++i) interface.status[i] = NodeStatus::slip;
  EXPECT_NEAR(ratio_of_edges(interface), 2., 1e-12);
}

TEST(FreeEnds, AreInDoubtByWhatParabolaAndLastNodeTellApart) {
  constexpr double h = 0.1;  // of a contact with the half-width 1 that ends at nodes
  const auto doubt_with = [&](const double last_over_law) {
    std::vector<double> pressures;
    for (int i = -10; i <= 10; ++i) pressures.push_back(std::sqrt(1. - std::pow(i * h, 2)));
    // the law: 0.31 edges are left of a last node at the end
    const double last = last_over_law * 0.825 * 0.31 * std::sqrt(2. * h);
    pressures.front() = pressures.back() = last;
    pressures.insert(pressures.begin(), 0.);
    pressures.push_back(0.);
    return share_of_free_ends(contact_of(pressures, h)).doubt;
  };
  EXPECT_NEAR(doubt_with(1.), 0., 1e-9) << "both have the end at the last node";
  // twice the pressure has it 0.31 edges farther out: d = -0.12 instead of 0.19
  EXPECT_NEAR(doubt_with(2.), 2. * (2. * 0.12 * 0.31 + 0.31 * 0.31) / (21. * 21.), 1e-6);
}

TEST(FreeEnds, OfAForcedContactLeaveThePressureOfTheFormula) {
  // p/p0 of a contact that has to end at -1 - d2 and 1 + d1, see peak_in_plane.h
  for (const auto& [d1, d2] :
       {std::pair(0.02, 0.02), std::pair(0.03, -0.01), std::pair(0., 0.02)}) {
    const double c = 1. + 0.5 * (d1 + d2);
    const double s = 0.5 * (d1 - d2);
    double maximum = 0.;
    for (double x = -0.1; x < 0.1; x += 1e-5)
      maximum = std::max(maximum, (1. + c * c - 2. * (x - s) * (x - s) - 2. * s * (x - s)) /
                                      (2. * std::sqrt(c * c - (x - s) * (x - s))));
    EXPECT_NEAR(maximum - 1., (d1 * d1 + d2 * d2) / 4., 1e-5);
  }
}

}  // namespace
}  // namespace geneva::fem::test
