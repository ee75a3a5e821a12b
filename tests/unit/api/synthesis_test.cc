#include "api/synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "api/design.h"
#include "api/kinematics.h"
#include "loads/pi.h"
#include "model/input/parameter_rule.h"
#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
using geneva::synthesize;
using geneva::base::UnitSystem;
using geneva::loads::CrankRockerInput;
using geneva::loads::PathDimension;
using geneva::loads::pi;
using geneva::loads::QuickReturnInput;
using geneva::model::Case;
using geneva::model::PathCase;
using geneva::post::SynthesisReport;

/// The parameters of a synthesis begin in line 3.
std::string synthesis_text(const std::string& lines, const std::string& after = "") {
  return "set Model = synthesis\nsubsection Synthesis\n" + lines + "end\n" + after;
}

const std::string quick_return =
    "set Kind = quick return\nset Stations = 6\nset Maximum wheel speed = 360 rpm\n";
const std::string crank_rocker =
    "set Kind = crank-rocker\nset Swing = 30 deg\nset Rocker = 100 mm\n"
    "set Crank pivot distance = 80 mm\n";
const std::string three_points = "x [mm], y [mm]\n0, 0\n10, 5\n20, 0\n";

/// A path case with its points.
std::string path_refusal(const std::string& points, const std::string& lines = "") {
  const CaseDirectory directory(synthesis_text("set Kind = path\n" + lines));
  directory.write("points.csv", points);
  return directory.refusal();
}

template <typename Task>
std::string message_of(const Task& task) {
  try {
    task();
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(SynthesisCase, AQuickReturnArrivesInSiUnits) {
  const Case given = CaseDirectory(synthesis_text(quick_return + "set Frame = 100 mm\n")).read();
  ASSERT_TRUE(given.synthesis.has_value());
  EXPECT_FALSE(given.mechanism.has_value());
  EXPECT_FALSE(given.geometry.has_value());
  const auto& input = std::get<QuickReturnInput>(*given.synthesis);
  EXPECT_EQ(input.stations, 6);
  EXPECT_NEAR(input.maximum_wheel_speed, 12. * pi, 1e-12);
  EXPECT_NEAR(input.centre_distance.value(), 0.1, 1e-15);
  EXPECT_FALSE(input.crank.has_value());
  EXPECT_EQ(CaseDirectory(given.completed).read().completed, given.completed);
}

TEST(SynthesisCase, ACrankRockerArrivesInSiUnits) {
  const Case given = CaseDirectory(synthesis_text(crank_rocker)).read();
  const auto& input = std::get<CrankRockerInput>(*given.synthesis);
  EXPECT_NEAR(input.swing, pi / 6., 1e-15);
  EXPECT_NEAR(input.rocker, 0.1, 1e-15);
  EXPECT_NEAR(input.pivot_distance, 0.08, 1e-15);
}

TEST(SynthesisCase, APathArrivesInSiUnitsWithItsGivenDimensions) {
  const CaseDirectory directory(
      synthesis_text("set Kind = path\nset Points = there.csv\nset Starts = 7\nset Seed = 9\n"
                     "set Crank pivot x = -1 in\nset Crank pivot y = 0 mm\n"
                     "set Rocker pivot x = 10 mm\nset Rocker pivot y = 20 mm\n"
                     "set Crank = 3 mm\nset Coupler point angle = -90 deg\n"));
  directory.write("there.csv", "# three points\nx [in], y [mm]\n0, 0\n\n1, -5e-1\n 2 , 3\n");
  const Case given = directory.read();
  const auto& path = std::get<PathCase>(*given.synthesis);
  EXPECT_EQ(path.task.starts, 7);
  EXPECT_EQ(path.task.seed, 9U);
  ASSERT_EQ(path.task.points.size(), 3U);
  EXPECT_NEAR(path.task.points[1][0], 0.0254, 1e-15);
  EXPECT_NEAR(path.task.points[1][1], -0.0005, 1e-15);
  ASSERT_EQ(path.task.given.size(), 6U);
  EXPECT_EQ(path.task.given[0].dimension, PathDimension::crank_pivot_x);
  EXPECT_NEAR(path.task.given[0].value, -0.0254, 1e-15);
  EXPECT_EQ(path.task.given[5].dimension, PathDimension::point_angle);
  EXPECT_NEAR(path.task.given[5].value, -pi / 2., 1e-15);
}

TEST(SynthesisCase, MissingValuesAreNamed) {
  EXPECT_EQ(refusal(synthesis_text("set Kind = quick return\nset Stations = 6\n")),
            "DIR/case.prm: 'Maximum wheel speed' is missing in the subsection 'Synthesis': 'Kind' "
            "= 'quick return' needs it");
  EXPECT_EQ(refusal(synthesis_text(quick_return)),
            "DIR/case.prm: 'Frame' is missing in the subsection 'Synthesis': 'Frame' or 'Crank' "
            "gives the size of the mechanism");
  EXPECT_EQ(refusal(synthesis_text("set Kind = crank-rocker\nset Swing = 30 deg\n"
                                   "set Rocker = 1 in\n")),
            "DIR/case.prm: 'Crank pivot distance' is missing in the subsection 'Synthesis': 'Kind' "
            "= 'crank-rocker' needs it");
}

TEST(SynthesisCase, BothSizesOfAQuickReturnAreRefused) {
  EXPECT_EQ(refusal(synthesis_text(quick_return + "set Frame = 100 mm\nset Crank = 50 mm\n")),
            "DIR/case.prm, line 7: 'Crank' = '50 mm': 'Frame' is given already, and the stations "
            "fix one by the other: give one of the two");
}

TEST(SynthesisCase, ParametersOfOtherKindsAreRefused) {
  EXPECT_EQ(refusal(synthesis_text(quick_return + "set Frame = 1 m\nset Swing = 30 deg\n")),
            "DIR/case.prm, line 7: 'Swing' = '30 deg': this has an effect with Kind = crank-rocker "
            "only, but this case has Kind = quick return");
  EXPECT_EQ(refusal(synthesis_text(crank_rocker + "set Crank = 30 mm\n")),
            "DIR/case.prm, line 7: 'Crank' = '30 mm': this has an effect with Kind = quick return "
            "or path only, but this case has Kind = crank-rocker");
  EXPECT_EQ(refusal(synthesis_text(crank_rocker + "set Starts = 30\n")),
            "DIR/case.prm, line 7: 'Starts' = '30': this has an effect with Kind = path only, but "
            "this case has Kind = crank-rocker");
}

TEST(SynthesisCase, SubsectionsOfOtherModelsAreRefused) {
  EXPECT_EQ(refusal(synthesis_text(crank_rocker, "subsection Mechanism\nend\n")),
            "DIR/case.prm, line 8: the subsection 'Mechanism' belongs to Model = mechanism, but "
            "this case has Model = synthesis");
  EXPECT_EQ(refusal(synthesis_text(crank_rocker, "subsection Published\nend\n")),
            "DIR/case.prm, line 8: the subsection 'Published' belongs to Model = mechanism or "
            "geometry, but this case has Model = synthesis");
  EXPECT_EQ(refusal(mechanism_text("", "subsection Synthesis\nend\n")),
            "DIR/case.prm, line 7: the subsection 'Synthesis' belongs to Model = synthesis, but "
            "this case has Model = mechanism (default)");
}

TEST(SynthesisCase, SettingsOfASolutionAreRefused) {
  EXPECT_EQ(refusal("set Accuracy = 1 %\n" + synthesis_text(crank_rocker)),
            "DIR/case.prm, line 1: there is no parameter 'Accuracy' outside of all subsections; "
            "there are 'Model', 'Title', 'Project', 'Author', 'Output units'");
}

TEST(SynthesisCase, AWrongNumberOfGivenDimensionsIsRefused) {
  const std::string pivots = "set Crank pivot x = 0 mm\nset Crank pivot y = 0 mm\n";
  EXPECT_EQ(path_refusal(three_points, pivots),
            "DIR/case.prm: subsection 'Synthesis': with 3 points exactly 6 of the nine dimensions "
            "are to be given, but given are 'Crank pivot x', 'Crank pivot y'; give 4 more of "
            "'Rocker pivot x', 'Rocker pivot y', 'Crank', 'Coupler', 'Rocker', 'Coupler point "
            "distance', 'Coupler point angle'");
  std::string nine = "x [mm], y [mm]\n";
  for (int i = 0; i < 9; ++i) nine += std::to_string(i) + ", 0\n";
  EXPECT_EQ(path_refusal(nine, pivots),
            "DIR/case.prm: subsection 'Synthesis': with 9 points none of the nine dimensions "
            "are to be given, but given are 'Crank pivot x', 'Crank pivot y'; leave out 2");
  EXPECT_EQ(path_refusal(nine), "accepted");
  EXPECT_NE(path_refusal(three_points).find("but none is given; give 6 more of"),
            std::string::npos);
}

TEST(SynthesisCase, AWrongNumberOfPointsIsRefused) {
  const std::string advice =
      ": a four-bar linkage can be made to pass 2 to 9; write a heading 'x [mm], y [mm]' and that "
      "many rows";
  for (const auto& [rows, count] : {std::pair("", "0"), std::pair("0, 0\n", "1")})
    EXPECT_EQ(path_refusal(std::string("x [mm], y [mm]\n") + rows),
              "DIR/points.csv: number of points is " + std::string(count) + advice);
  std::string ten = "x [mm], y [mm]\n";
  for (int i = 0; i < 10; ++i) ten += std::to_string(i) + ", 0\n";
  EXPECT_EQ(path_refusal(ten), "DIR/points.csv: number of points is 10" + advice);
}

TEST(SynthesisCase, LengthsBeyondAllMachinesAreRefused) {
  EXPECT_EQ(refusal(synthesis_text(quick_return + "set Crank = 1e300 m\n")),
            "DIR/case.prm, line 6: 'Crank' = '1e300 m': the value must be from 1 nm to 1000 km");
  EXPECT_EQ(path_refusal("x [m], y [m]\n0, 0\n1, -1e200\n"),
            "DIR/points.csv: point 2 is (1, -1e+200) m: a coordinate must be from -1000 to 1000 "
            "km");
}

TEST(SynthesisCase, WhatIsNoTableOfPointsIsRefused) {
  EXPECT_EQ(path_refusal("0, 0\n1, 1\n"),
            "DIR/points.csv, line 1: the heading is '0': 'x [mm], y [mm]' is wanted, with any unit "
            "of length");
  EXPECT_NE(path_refusal("x [s], y [mm]\n").find("points.csv, line 1: "), std::string::npos);
  for (const char* row : {"1, nan", "1, inf", "1, ", "1e999, 1", "one, 1"})
    EXPECT_EQ(path_refusal(std::string("x [mm], y [mm]\n") + row + "\n"),
              "DIR/points.csv, line 2: '" + geneva::model::trimmed(row) +
                  "' is not two numbers separated by a comma");
  EXPECT_EQ(path_refusal("x [mm], y [mm]\n1, 2, 3\n"),
            "DIR/points.csv, line 2: '1, 2, 3' is not two columns separated by a comma");
}

TEST(SynthesisCase, PointsOutsideOfTheDirectoryAreRefused) {
  EXPECT_EQ(refusal(synthesis_text("set Kind = path\nset Points = ../points.csv\n")),
            "DIR/case.prm, line 4: 'Points' = '../points.csv': a file in the case directory is "
            "wanted, not one outside of it");
  EXPECT_EQ(refusal(synthesis_text("set Kind = path\n")),
            "DIR/case.prm: 'Points' = 'points.csv' (default): there is no such file in the case "
            "directory");
}

std::string file_of(const Case& given) { return (given.directory / "case.prm: ").string(); }

TEST(Synthesis, OtherCommandsRefuseTheCaseAndItRefusesOtherCases) {
  const Case synthesis = CaseDirectory(synthesis_text(crank_rocker)).read();
  const Case mechanism = CaseDirectory(mechanism_text()).read();
  EXPECT_EQ(
      message_of([&] { synthesize(mechanism); }),
      file_of(mechanism) +
          "'Model' = 'mechanism': there is no linkage to find; 'geneva synthesize' wants a case "
          "with Model = synthesis");
  EXPECT_EQ(
      message_of([&] { geneva::design(synthesis); }),
      file_of(synthesis) +
          "'Model' = 'synthesis': there is no wheel to design; 'geneva design' wants a case with "
          "Model = mechanism, this one is for 'geneva synthesize'");
  EXPECT_EQ(
      message_of([&] { geneva::kinematics(synthesis, 10); }),
      file_of(synthesis) +
          "'Model' = 'synthesis': there is no Geneva mechanism; 'geneva kinematics' wants a case "
          "with Model = mechanism, this one is for 'geneva synthesize'");
}

TEST(Synthesis, AQuickReturnIsReportedWithItsFourExtremePositions) {
  const SynthesisReport report =
      synthesize(CaseDirectory(synthesis_text(quick_return + "set Crank = 50 mm\n")).read()).report;
  const nlohmann::json summary = geneva::post::synthesis_summary(report);
  EXPECT_EQ(summary["kind"], "quick_return");
  const nlohmann::json& section = summary["quick_return"];
  EXPECT_NEAR(section["frame"]["value"], 0.1, 1e-15);
  EXPECT_NEAR(section["crank_speed"]["value"], 12. * pi, 1e-12);
  EXPECT_NEAR(section["engagement_angle"]["value"], 2. * pi / 3., 1e-15);
  EXPECT_EQ(section["k_t"], 0.5);
  const nlohmann::json& extremes = section["extreme_positions"];
  EXPECT_NEAR(extremes["slider_nearest"]["slider_distance"]["value"], 0.05, 1e-15);
  EXPECT_NEAR(extremes["slider_farthest"]["slider_distance"]["value"], 0.15, 1e-15);
  EXPECT_NEAR(extremes["rocker_first"]["rocker_angle"]["value"], -pi / 6., 1e-15);
  EXPECT_NEAR(extremes["rocker_last"]["crank_angle"]["value"], pi / 3., 1e-15);
  const std::string text = geneva::post::synthesis_csv(report, UnitSystem::mm_newton);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "crank_angle [deg],rocker_angle [deg],slider_distance [mm],rocker_speed [rpm],"
            "slider_speed [mm/s]");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 362);
}

TEST(Synthesis, ACrankRockersSwingAndTimesAreThoseOfItsPositions) {
  const SynthesisReport report =
      synthesize(CaseDirectory(synthesis_text(crank_rocker)).read()).report;
  const nlohmann::json section = geneva::post::synthesis_summary(report)["crank_rocker"];
  EXPECT_NEAR(section["swing"]["value"], pi / 6., 1e-14);
  EXPECT_NEAR(section["time_ratio"], 1., 1e-15);
  EXPECT_EQ(section["crank_turns_fully"], true);
  EXPECT_NEAR(section["crank"]["value"], 0.1 * std::sin(pi / 12.), 1e-15);
  for (const char* name : {"rocker_farthest", "rocker_nearest"})
    EXPECT_NEAR(section["extreme_positions"][name]["speed_ratio"], 0., 1e-14);
}

TEST(Synthesis, ASwingThatMakesNoLinkageIsRefused) {
  EXPECT_EQ(refusal(synthesis_text("set Kind = crank-rocker\nset Swing = 180 deg\n")),
            "DIR/case.prm, line 4: 'Swing' = '180 deg': the value must be greater than 0 and less "
            "than 180 deg");
}

TEST(Synthesis, APathHasAllThatWasAskedInItsSummary) {
  const CaseDirectory directory(synthesis_text(
      "set Kind = path\nset Starts = 50\nset Crank pivot x = 0 mm\nset Crank pivot y = -20 mm\n"
      "set Rocker pivot x = 40 mm\nset Rocker pivot y = -20 mm\nset Coupler point angle = 30 deg\n"
      "set Crank = 15 mm\n"));
  directory.write("points.csv", three_points);
  const SynthesisReport report = synthesize(directory.read()).report;
  const nlohmann::json summary = geneva::post::synthesis_summary(report);
  const nlohmann::json& path = summary["path"];
  EXPECT_EQ(path["starts"], 50);
  EXPECT_EQ(path["seed"], 1);
  EXPECT_EQ(path["points"].size(), 3U);
  EXPECT_EQ(path["given"].size(), 6U);
  EXPECT_EQ(path["given"]["point_angle"]["unit"], "rad");
  const std::string text = geneva::post::synthesis_csv(report, UnitSystem::si);
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            path["solutions"].size() + 1);
  EXPECT_NE(text.find("point_angle [rad]"), std::string::npos);
  EXPECT_NE(text.find("crank_angle_3 [rad]\n"), std::string::npos);
}

TEST(Synthesis, PointsThatAreTheSameAreRefusedWithTheirFile) {
  const CaseDirectory directory(synthesis_text(
      "set Kind = path\nset Crank pivot x = 0 mm\nset Crank pivot y = 0 mm\nset Rocker pivot x = 1 "
      "mm\nset Rocker pivot y = 0 mm\nset Crank = 1 mm\nset Rocker = 1 mm\nset Coupler = 1 mm\n"));
  directory.write("points.csv", "x [mm], y [mm]\n1, 2\n1, 2\n");
  const Case given = directory.read();
  const std::string message = message_of([&] { synthesize(given); });
  EXPECT_NE(message.find("points.csv: points 1 and 2 are both (1, 2) mm"), std::string::npos);
}

}  // namespace
