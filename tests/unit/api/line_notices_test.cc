#include "api/analysis_notices.h"

#include <gtest/gtest.h>

namespace geneva::api {
namespace {

constexpr double inch = 0.0254;
constexpr double psi = 6894.757293168361;

/// Johnson's optimum wheel with a crowned pin, held at one end, as line contacts.
post::PinReport crowned_pin(const double overhang) {
  loads::PinLine pin{};
  pin.pin = {30e6 * psi, 0.3};
  pin.wheel = pin.pin;
  pin.radius = 0.6795 / 2. * inch;
  pin.relative_radius = pin.radius;
  pin.clearance.wall_half = pin.radius;
  pin.clearance.lower_end = -pin.radius - overhang;
  pin.clearance.upper_end = pin.radius + 0.4 * inch;
  pin.clearance.profile = loads::Crown{120. * inch};
  post::PinReport report{};
  report.line.emplace();
  report.line->pin = pin;
  report.line->contact = loads::pin_line_contact(pin, 1033.732, 1e-4);
  report.line->doubt = loads::peak_doubt(pin, report.line->contact);
  return report;
}

/// A solution whose peak is a factor times that of the line contacts, with an error.
fem::Solution<3> solved(const post::PinReport& pin, const double factor, const double error) {
  fem::Solution<3> solution;
  solution.contacts.emplace_back();
  solution.contacts.front().peak_pressure = factor * pin.line->contact.peak_pressure;
  solution.error_estimate = error;
  return solution;
}

std::vector<std::string> notices(const post::PinReport& pin, const double factor,
                                 const double error) {
  post::Results<3> results{};
  results.contacts.emplace_back();
  return line_notices(pin, solved(pin, factor, error), results);
}

TEST(LineNotices, SayNothingWhereBothAgreeWithinTheirErrors) {
  const post::PinReport pin = crowned_pin(0.4 * inch);
  ASSERT_EQ(pin.line->doubt, loads::PeakDoubt::none);
  const double expected = loads::expected_error(pin.line->pin, pin.line->contact);
  EXPECT_TRUE(notices(pin, 1. + 0.01 + 0.99 * expected, 0.01).empty());
  EXPECT_TRUE(notices(pin, 1. - 0.01 - 0.99 * expected, 0.01).empty());
}

TEST(LineNotices, DoubtFiniteElementsThatDifferByMoreThanBothErrors) {
  const post::PinReport pin = crowned_pin(0.4 * inch);
  const double expected = loads::expected_error(pin.line->pin, pin.line->contact);
  const auto found = notices(pin, 1. + 0.012 + expected, 0.01);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().find("doubt the finite elements"), std::string::npos) << found.front();
}

TEST(LineNotices, DoubtLineContactsOfAPinThatEndsBesideTheContact) {
  const post::PinReport pin = crowned_pin(-0.1 * inch);
  ASSERT_TRUE(loads::is_near_end(pin.line->pin, pin.line->contact));
  const double expected = loads::expected_error(pin.line->pin, pin.line->contact);
  const auto found = notices(pin, 1. + 0.012 + expected, 0.01);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().find("doubt the line contacts"), std::string::npos) << found.front();
}

TEST(LineNotices, DoNotCompareAPeakThatLineContactsDoNotKnow) {
  post::PinReport pin = crowned_pin(0.4 * inch);
  pin.line->doubt = loads::PeakDoubt::reaches_edge;
  EXPECT_TRUE(notices(pin, 2., 0.01).empty());
}

}  // namespace
}  // namespace geneva::api
