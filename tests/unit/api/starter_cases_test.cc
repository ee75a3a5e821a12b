// Every case that `geneva init` makes, read and computed without finite elements.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "api/case.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "loads/pi.h"
#include "model/input/starter_case.h"
#include "tests/support/private_directory.h"

namespace {

using namespace geneva;
using loads::pi;

class StarterCase : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] Case given() const {
    for (const model::StarterFile& file :
         model::starter_case({GetParam(), std::nullopt, base::UnitSystem::mm_newton}))
      (void)directory_.write(file.name, file.text);
    return read_case(directory_.path());
  }

  test::PrivateDirectory directory_;
};

TEST_P(StarterCase, IsTheSameAsItWasCompleted) {
  const auto completed = [&](const std::string& text) {
    (void)directory_.write("case.prm", text);
    return read_case(directory_.path()).completed;
  };
  const Case once = given();
  ASSERT_TRUE(once.mechanism);
  const std::string twice = completed(once.completed);
  EXPECT_TRUE(completed(twice) == twice);
}

TEST_P(StarterCase, MovesAsFarAsItsStationsAsk) {
  const Kinematics motion = kinematics(given(), 360);
  EXPECT_GE(motion.report.rows.size(), 361U) << "and the joints of the motion";
  EXPECT_GT(motion.report.values.force.value, 0.);
  for (const char* const part : {"maximum pin force [N]", "deg"})
    EXPECT_NE(table(motion).find(part), std::string::npos) << part;
  const Written written = write(motion, directory_.path() / "kinematics");
  for (const char* const name : {"kinematics.json", "kinematics.csv", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(directory_.path() / "kinematics" / name)) << name;
}

TEST_P(StarterCase, IsPressedAsHertzHasIt) {
  const Estimate found = estimate(given());
  const post::EstimateReport& report = found.report;
  const double hertz =
      std::sqrt(report.even_line_load * report.contact_modulus / (pi * report.relative_radius));
  EXPECT_NEAR(report.even.peak_pressure, hertz, 1e-9 * hertz);
  EXPECT_FALSE(report.line) << "in the plane";
  EXPECT_FALSE(report.engagement.empty());
  EXPECT_NE(table(found).find("peak contact pressure [MPa]"), std::string::npos) << table(found);
  (void)write(found, directory_.path() / "estimate");
  for (const char* const name : {"estimate.json", "estimate.csv", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(directory_.path() / "estimate" / name)) << name;
}

INSTANTIATE_TEST_SUITE_P(OfEachType, StarterCase,
                         testing::Values("external", "internal", "spherical", "long dwell",
                                         "four-bar"),
                         [](const auto& type) {
                           std::string name = type.param;
                           name.erase(
                               std::remove_if(name.begin(), name.end(),
                                              [](const char c) { return c == ' ' || c == '-'; }),
                               name.end());
                           return name;
                         });

TEST(StarterCases, AreThereForAllTypesAndRefusedForOthers) {
  for (const std::string& type : model::starter_types())
    EXPECT_FALSE(model::starter_case({type, std::nullopt, base::UnitSystem::si}).empty()) << type;
  EXPECT_THROW(model::starter_case({"wheel", std::nullopt, base::UnitSystem::si}), InputError);
  EXPECT_THROW(model::starter_case({"geometry", 4, base::UnitSystem::si}), InputError);
}

}  // namespace
