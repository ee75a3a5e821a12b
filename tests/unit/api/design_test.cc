#include "api/design.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
using geneva::design;
using geneva::base::UnitSystem;
using geneva::loads::GivenLengths;
using geneva::model::Case;
using geneva::post::DesignReport;

constexpr double inch = 0.0254;

std::string design_text(const std::string& lines, const std::string& inside = "") {
  return mechanism_text(inside + "  subsection Design\n" + lines + "  end\n");
}

/// "DIR/case.prm, line N: 'Design/NAME' = 'VALUE': REASON" for the first line of the subsection.
std::string refused(const std::string& name, const std::string& value, const std::string& reason) {
  return "DIR/case.prm, line 7: 'Design/" + name + "' = '" + value + "': " + reason;
}

TEST(DesignCase, WithoutItsSubsectionThereIsNoShaftAndLengthsScale) {
  const Case given = CaseDirectory(mechanism_text()).read();
  EXPECT_FALSE(given.mechanism->design.shaft.has_value());
  EXPECT_FALSE(given.mechanism->design.adds_shaft_inertia);
  EXPECT_FALSE(given.mechanism->design.amplitude_radius.has_value());
  EXPECT_EQ(given.mechanism->design.given_lengths, GivenLengths::scale);
}

TEST(DesignCase, EveryParameterArrivesInSiUnits) {
  const Case given = CaseDirectory(design_text("set Given lengths = stay as given\n"
                                               "set Shaft = 0.375 in x 5 in, 25 mm x 0.1 m\n"
                                               "set Shaft shear modulus = 80 GPa\n"
                                               "set Shaft density = 7.8 g/cm^3\n"
                                               "set Amplitude radius = 2 in\n"
                                               "set Add shaft inertia = true\n"))
                         .read();
  const auto& design = given.mechanism->design;
  EXPECT_EQ(design.given_lengths, GivenLengths::stay);
  ASSERT_TRUE(design.shaft.has_value());
  ASSERT_EQ(design.shaft->segments.size(), 2U);
  EXPECT_NEAR(design.shaft->segments[0].diameter, 0.375 * inch, 1e-15);
  EXPECT_NEAR(design.shaft->segments[0].length, 5. * inch, 1e-15);
  EXPECT_NEAR(design.shaft->segments[1].diameter, 0.025, 1e-15);
  EXPECT_NEAR(design.shaft->segments[1].length, 0.1, 1e-15);
  EXPECT_NEAR(design.shaft->shear_modulus, 80e9, 1e-3);
  EXPECT_NEAR(design.shaft->density, 7800., 1e-9);
  EXPECT_NEAR(*design.amplitude_radius, 2. * inch, 1e-15);
  EXPECT_TRUE(design.adds_shaft_inertia);
  EXPECT_EQ(CaseDirectory(given.completed).read().completed, given.completed);
}

TEST(DesignCase, TheRimOfACylinderIsWhereTheAmplitudeIsTold) {
  const Case given = CaseDirectory(
                         "subsection Mechanism\n set Stations = 6\n set Wheel diameter = 115 mm\n"
                         " set Driver speed = 600 rpm\n set Load inertia = solid cylinder\n"
                         " set Load diameter = 100 mm\n set Load length = 20 mm\n"
                         " set Load density = 7850 kg/m^3\n subsection Design\n"
                         " set Shaft = 10 mm x 50 mm\n end\nend\n")
                         .read();
  EXPECT_NEAR(*given.mechanism->design.amplitude_radius, 0.05, 1e-15);
}

TEST(DesignCase, AMisspeltShaftIsRefused) {
  const std::string form =
      ": a segment is a diameter, ' x ' and a length, for example '0.375 in x 5 in'";
  for (const std::string& part : {std::string("1 in"), std::string("1 in x 2 in x 3 in"),
                                  std::string("1 in x"), std::string("1 in x5 in")})
    EXPECT_EQ(refusal(design_text("set Shaft = " + part + "\n")),
              refused("Shaft", part, "'" + part + "'" + form));
  EXPECT_EQ(refusal(design_text("set Shaft = 1 in x 3 in,\n")),
            refused("Shaft", "1 in x 3 in,", "''" + form));
  EXPECT_EQ(refusal(design_text("set Shaft = 1 in x 3\n")),
            refused("Shaft", "1 in x 3",
                    "'3': a length with its unit is wanted, for example '4.53 in' or '115 mm'"));
  EXPECT_EQ(refusal(design_text("set Shaft = 0 in x 3 in\n")),
            refused("Shaft", "0 in x 3 in", "'0 in': the value must be greater than 0"));
}

TEST(DesignCase, WhatHasNoEffectWithoutAShaftIsRefused) {
  EXPECT_EQ(refusal(design_text("set Amplitude radius = 2 in\n")),
            refused("Amplitude radius", "2 in", "this has no effect without a 'Shaft'"));
  EXPECT_EQ(refusal(design_text("set Add shaft inertia = true\n")),
            refused("Add shaft inertia", "true", "this has no effect without a 'Shaft'"));
}

TEST(Design, TheCasesOwnWheelIsTheOneOfARun) {
  const Case given = CaseDirectory(mechanism_text("  set Wheel inertia = 0.003 lbf.s^2.in\n"
                                                  "  set Driver angle = at maximum pin force\n"))
                         .read();
  const DesignReport report = design(given).report;
  EXPECT_NEAR(report.own.diameter, 4.53 * inch, 1e-15);
  EXPECT_EQ(report.own.inertia, given.mechanism->wheel_inertia);
  const double arm = report.row.k * report.own.diameter;
  EXPECT_NEAR(report.own.force * arm,
              (report.own.inertia + given.mechanism->load.load_inertia) * report.peak_acceleration,
              1e-12);
}

TEST(Design, TheShaftsInertiaIsAddedToTheLoadButNotToItsVibration) {
  const std::string shaft = "set Shaft = 1 in x 3 in\n";
  const DesignReport without = design(CaseDirectory(design_text(shaft)).read()).report;
  const DesignReport with =
      design(CaseDirectory(design_text(shaft + "set Add shaft inertia = true\n")).read()).report;
  EXPECT_NEAR(with.load.load_inertia - without.load.load_inertia, without.shaft->inertia, 1e-15);
  // M_f = 0: Eq. 9 is J_G = 1.5 J_L
  EXPECT_NEAR(with.johnson->inertia / with.load.load_inertia, 1.5, 1e-12);
  EXPECT_GT(with.own.force, without.own.force);
  EXPECT_EQ(with.shaft->vibration.frequency, without.shaft->vibration.frequency);
  EXPECT_EQ(with.shaft->vibration.twist, without.shaft->vibration.twist);
}

TEST(Design, AGeometryCaseIsRefused) {
  Case given = CaseDirectory(mechanism_text()).read();
  given.mechanism.reset();
  EXPECT_THROW(design(given), std::invalid_argument);
}

TEST(Design, TheSummaryHasUnitsAndTheWholeTable) {
  const DesignReport report =
      design(CaseDirectory(design_text("set Shaft = 1 in x 3 in\n")).read()).report;
  const nlohmann::json summary = geneva::post::design_summary(report);
  EXPECT_EQ(summary["optimum_diameter"]["unit"], "m");
  EXPECT_EQ(summary["optimum_diameter"]["value"], report.johnson->diameter);
  EXPECT_EQ(summary["wheel"]["inertia"]["unit"], "kg m^2");
  EXPECT_EQ(summary["geometry"]["given_lengths"], "scale with the wheel");
  EXPECT_FALSE(summary["shaft"].contains("double_amplitude"));  // no radius is known
  ASSERT_EQ(summary["table"].size(), 22U);
  EXPECT_EQ(summary["table"][0]["n"], 3);
  EXPECT_EQ(summary["table"][7]["k5"], 0.0054);
  EXPECT_FALSE(summary["table"][8].contains("k5"));
}

TEST(Design, BeyondTenStationsTheSummaryHasNoOptimumOfJohnsons) {
  Case given = CaseDirectory(mechanism_text()).read();
  given.mechanism->dimensions.stations = 12;
  const DesignReport report = design(given).report;
  const nlohmann::json summary = geneva::post::design_summary(report);
  EXPECT_FALSE(summary.contains("optimum_diameter"));
  EXPECT_TRUE(summary["geometry"].contains("optimum_diameter"));
  EXPECT_FALSE(summary.contains("shaft"));
  EXPECT_NE(geneva::post::design_csv(report, UnitSystem::si).find(",,,"), std::string::npos);
}

TEST(Design, TheCurveIsWrittenInOutputUnits) {
  const DesignReport report = design(CaseDirectory(mechanism_text()).read()).report;
  const std::string text = geneva::post::design_csv(report, UnitSystem::mm_newton);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "diameter [mm],inertia_johnson [kg.mm^2],force_johnson [N],stress_johnson "
            "[MPa],inertia_geometry [kg.mm^2],force_geometry [N],stress_geometry [MPa]");
  EXPECT_NEAR(std::stod(text.substr(text.find('\n'))), 300. * report.johnson->diameter, 1e-8);
}

TEST(Design, SeveralCasesStandSideBySide) {
  DesignReport first = design(CaseDirectory(mechanism_text()).read()).report;
  DesignReport second =
      design(CaseDirectory(design_text("set Shaft = 1 in x 3 in\n")).read()).report;
  first.about.name = "first";
  second.about.name = "a-name-that-is-longer-than-its-column";
  const std::string table = geneva::post::design_table({first, second}, UnitSystem::inch_pound);
  EXPECT_NE(table.find("first  a-name-that-is-longer-than-its-column\n"), std::string::npos);
  EXPECT_NE(table.find("  diameter [in]"), std::string::npos);
  const std::size_t twist = table.find("  twist [rad]");
  ASSERT_NE(twist, std::string::npos);
  EXPECT_NE(table.substr(twist, 90).find(" - "), std::string::npos);  // the first has no shaft
}

}  // namespace
