#include "post/output/load_history_output.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

namespace geneva::post {
namespace {

ContactAtStep contact(const double force, const double friction, const double pressure) {
  return {"pin", "wall", {0., force, 0.}, {friction, 0., 0.}, pressure, 1e-4, 0.01, 3, 2, 0.5};
}

LoadHistoryReport history() {
  LoadHistoryReport report{};
  report.about.name = "case";
  report.about.units = base::UnitSystem::mm_newton;
  report.accuracy = 0.01;
  report.error = 0.004;
  report.steps = {{0., {contact(10., 1e-12, 2e8), contact(0., 0., 0.)}, {}, 1., 2.},
                  {1., {contact(20., 4., 5e8), contact(0., 0., 0.)}, {}, 1., 2.},
                  {2., {contact(20., -4., 5e8 * (1. - 1e-13)), contact(0., 0., 0.)}, {}, 1., 2.}};
  return report;
}

TEST(LoadHistory, TakesTheLastOfEqualPressuresForTheGreatest) {
  const auto greatest = greatest_pressure(history());
  ASSERT_TRUE(greatest.has_value());
  EXPECT_EQ(greatest->step, 2U);
  EXPECT_EQ(greatest->contact, 0U);
  EXPECT_NE(load_history_table(history(), base::UnitSystem::mm_newton)
                .find("greatest peak pressure: 500 MPa +- 0.4 % at step 3 of 3, pin -> wall"),
            std::string::npos);
}

TEST(LoadHistory, HasNoGreatestPressureWhereNothingIsPressed) {
  LoadHistoryReport report = history();
  for (LoadStepPoint& step : report.steps) step.contacts = {contact(0., 0., 0.)};
  EXPECT_FALSE(greatest_pressure(report).has_value());
  EXPECT_TRUE(load_history_summary(report).at("greatest").is_null());
}

TEST(LoadHistory, HasALineForEachStepAndContact) {
  const std::string csv = load_history_csv(history(), base::UnitSystem::mm_newton);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  EXPECT_NE(csv.find("\n2,1,pin -> wall,0,20,0,4,0,0,500,0.1,0.01,3,2,0.5,1,2\n"),
            std::string::npos)
      << csv;
}

TEST(LoadHistory, TellsSIUnitsToJson) {
  const nlohmann::json found = load_history_summary(history());
  EXPECT_EQ(found.at("steps").size(), 3U);
  const nlohmann::json& contact = found.at("steps")[1].at("contacts")[0];
  EXPECT_EQ(contact.at("peak_pressure").at("value"), 5e8);
  EXPECT_EQ(contact.at("friction_force")[0].at("unit"), "N");
  EXPECT_EQ(found.at("error_of_last_step"), 0.004);
}

}  // namespace
}  // namespace geneva::post
