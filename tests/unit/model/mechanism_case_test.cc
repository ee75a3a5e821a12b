#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
using geneva::model::Case;
using geneva::model::CaseMaterial;
using geneva::model::MechanismCase;

constexpr double pi = 3.14159265358979323846;

/// Every parameter, in inches and pounds.
const char* const inch_text = R"(
set Model = mechanism
set Title = Johnson, Example 1
set Output units = in-lbf
set Accuracy = 0.1 %
set Maximum refinement levels = 12
set Maximum unknowns = 5e5
set Maximum memory = 2 GiB
set Maximum active-set steps = 30
set Linear tolerance = 1e-9
set Linear solver = ML
subsection Mechanism
  set Stations = 6
  set Crank radius = 1.3077 in
  set Pin diameter = 0.625 in
  set Wheel thickness = 0.75 in
  set Slot clearance = 0.002 in
  set Slot depth = 1.6 in
  set Locking radius = 0.8 in
  set Bore radius = 0.3 in
  set Pin core radius = 0.15 in
  set Driver speed = 600 rpm
  set Driver acceleration = -30 rpm/s
  set Driver angle = -11.46 deg
  set Wheel inertia = 0.003 lbf.s^2.in
  set Load inertia = 0.0046 lbf.s^2.in
  set Friction moment = 2 lbf.in
  subsection Pin material
    set Young's modulus = 30e6 psi
    set Poisson's ratio = 0.28
    set Density = 0.283 lb/in^3
  end
  subsection Wheel material
    set Young's modulus = 15e6 psi
    set Poisson's ratio = 0.25
    set Density = 0.26 lb/in^3
  end
end
subsection Published
  set Peak pressure = 58000 psi
  set Source = Johnson (1956), page 123
end
)";

/// The same in SI units.
const char* const metre_text = R"(
set Model = mechanism
set Title = Johnson, Example 1
set Output units = in-lbf
set Accuracy = 0.001
set Maximum refinement levels = 12
set Maximum unknowns = 500000
set Maximum memory = 2147483648 B
set Maximum active-set steps = 30
set Linear tolerance = 1e-9
subsection Mechanism
  set Stations = 6
  set Crank radius = 0.03321558 m
  set Pin diameter = 0.015875 m
  set Wheel thickness = 0.01905 m
  set Slot clearance = 0.0000508 m
  set Slot depth = 0.04064 m
  set Locking radius = 0.02032 m
  set Bore radius = 0.00762 m
  set Pin core radius = 0.00381 m
  set Driver speed = 62.83185307179586477 rad/s
  set Driver acceleration = -3.141592653589793238 rad/s^2
  set Driver angle = -0.20001473227855016952 rad
  set Wheel inertia = 0.00033895448708285010000 kg.m^2
  set Load inertia = 0.00051973021352703682000 kg.m^2
  set Friction moment = 0.22596965805523340000 N.m
  subsection Pin material
    set Young's modulus = 206842718795.05084010 Pa
    set Poisson's ratio = 0.28
    set Density = 7833.4130329874832978 kg/m^3
  end
  subsection Wheel material
    set Young's modulus = 103421359397.52542005 Pa
    set Poisson's ratio = 0.25
    set Density = 7196.7752246528115103 kg/m^3
  end
end
subsection Published
  set Peak pressure = 399895923.00376495753 Pa
  set Source = Johnson (1956), page 123
end
)";

/// Equal to the roundings of a few multiplications.
void expect_same(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-15 * std::abs(expected));
}

void expect_same(const std::optional<double>& value, const std::optional<double>& expected) {
  ASSERT_EQ(value.has_value(), expected.has_value());
  if (value) expect_same(*value, *expected);
}

void expect_same(const CaseMaterial& value, const CaseMaterial& expected) {
  expect_same(value.youngs_modulus, expected.youngs_modulus);
  expect_same(value.poissons_ratio, expected.poissons_ratio);
  expect_same(value.density, expected.density);
}

void expect_same(const MechanismCase& value, const MechanismCase& expected) {
  const auto& found = value.dimensions;
  const auto& wanted = expected.dimensions;
  EXPECT_EQ(found.stations, wanted.stations);
  expect_same(found.wheel_diameter, wanted.wheel_diameter);
  expect_same(found.crank_radius, wanted.crank_radius);
  expect_same(found.centre_distance, wanted.centre_distance);
  expect_same(found.pin_diameter, wanted.pin_diameter);
  expect_same(found.thickness, wanted.thickness);
  expect_same(found.slot_clearance, wanted.slot_clearance);
  expect_same(found.slot_width, wanted.slot_width);
  expect_same(found.slot_depth, wanted.slot_depth);
  expect_same(found.locking_radius, wanted.locking_radius);
  expect_same(found.bore_radius, wanted.bore_radius);
  expect_same(found.pin_core_radius, wanted.pin_core_radius);
  expect_same(value.motion.speed, expected.motion.speed);
  expect_same(value.motion.acceleration, expected.motion.acceleration);
  expect_same(value.load.load_inertia, expected.load.load_inertia);
  expect_same(value.load.friction_moment, expected.load.friction_moment);
  EXPECT_EQ(value.angle_kind, expected.angle_kind);
  expect_same(value.driver_angle, expected.driver_angle);
  EXPECT_EQ(value.inertia_kind, expected.inertia_kind);
  expect_same(value.wheel_inertia, expected.wheel_inertia);
  expect_same(value.pin, expected.pin);
  expect_same(value.wheel, expected.wheel);
}

void expect_same(const Case& value, const Case& expected) {
  EXPECT_EQ(value.title, expected.title);
  EXPECT_EQ(value.units, expected.units);
  expect_same(value.settings.accuracy, expected.settings.accuracy);
  EXPECT_EQ(value.settings.max_levels, expected.settings.max_levels);
  EXPECT_EQ(value.settings.max_dofs, expected.settings.max_dofs);
  expect_same(value.settings.max_memory, expected.settings.max_memory);
  EXPECT_EQ(value.settings.max_active_set_steps, expected.settings.max_active_set_steps);
  expect_same(value.settings.linear_tolerance, expected.settings.linear_tolerance);
  expect_same(value.published_peak_pressure, expected.published_peak_pressure);
  EXPECT_EQ(value.published_source, expected.published_source);
  EXPECT_FALSE(value.geometry.has_value());
  ASSERT_TRUE(value.mechanism.has_value());
  expect_same(*value.mechanism, *expected.mechanism);
}

TEST(MechanismCase, EveryParameterArrivesInSiUnits) {
  const Case given = CaseDirectory(inch_text).read();
  EXPECT_EQ(given.title, "Johnson, Example 1");
  EXPECT_EQ(given.units, geneva::base::UnitSystem::inch_pound);
  expect_same(given.settings.accuracy, 0.001);
  EXPECT_EQ(given.settings.max_levels, 12U);
  EXPECT_EQ(given.settings.max_dofs, 500000U);
  expect_same(given.settings.max_memory, 2147483648.);
  EXPECT_EQ(given.settings.max_active_set_steps, 30U);
  EXPECT_EQ(given.settings.linear_solver, geneva::fem::LinearSolver::library);
  expect_same(given.settings.linear_tolerance, 1e-9);
  EXPECT_EQ(given.published_source, "Johnson (1956), page 123");
  const MechanismCase& mechanism = *given.mechanism;
  EXPECT_EQ(mechanism.dimensions.stations, 6);
  EXPECT_FALSE(mechanism.dimensions.wheel_diameter);
  EXPECT_FALSE(mechanism.dimensions.centre_distance);
  EXPECT_FALSE(mechanism.dimensions.slot_width);
  expect_same(mechanism.dimensions.crank_radius, 0.03321558);
  expect_same(mechanism.dimensions.slot_clearance, 0.0000508);
  expect_same(mechanism.motion.speed, 20. * pi);
  expect_same(mechanism.motion.acceleration, -pi);
  EXPECT_EQ(mechanism.angle_kind, MechanismCase::AngleKind::given);
  expect_same(mechanism.driver_angle, -11.46 * pi / 180.);
  EXPECT_EQ(mechanism.inertia_kind, MechanismCase::InertiaKind::given);
  expect_same(mechanism.pin.poissons_ratio, 0.28);
  expect_same(mechanism.wheel.poissons_ratio, 0.25);
}

TEST(MechanismCase, InchesAndMetresGiveTheSameCase) {
  expect_same(CaseDirectory(inch_text).read(), CaseDirectory(metre_text).read());
}

TEST(MechanismCase, InSpaceTheDefaultAccuracyIsCoarser) {
  const std::string in_space = "set Dimension = 3\n" + mechanism_text();
  EXPECT_DOUBLE_EQ(CaseDirectory(in_space).read().settings.accuracy, 0.05);
  EXPECT_DOUBLE_EQ(CaseDirectory("set Accuracy = 1 %\n" + in_space).read().settings.accuracy, 0.01);
}

TEST(MechanismCase, WhatIsLeftOutTakesItsDefault) {
  const Case given = CaseDirectory(mechanism_text()).read();
  const geneva::fem::Settings settings;
  EXPECT_EQ(given.title, "");
  EXPECT_EQ(given.units, geneva::base::UnitSystem::si);
  EXPECT_DOUBLE_EQ(given.settings.accuracy, settings.accuracy);
  EXPECT_EQ(given.settings.max_levels, settings.max_levels);
  EXPECT_EQ(given.settings.max_dofs, settings.max_dofs);
  EXPECT_DOUBLE_EQ(given.settings.max_memory, settings.max_memory);
  EXPECT_EQ(given.settings.max_active_set_steps, settings.max_active_set_steps);
  EXPECT_DOUBLE_EQ(given.settings.linear_tolerance, settings.linear_tolerance);
  EXPECT_FALSE(given.published_peak_pressure);
  const MechanismCase& mechanism = *given.mechanism;
  for (const auto& length :
       {mechanism.dimensions.pin_diameter, mechanism.dimensions.thickness,
        mechanism.dimensions.slot_clearance, mechanism.dimensions.slot_width,
        mechanism.dimensions.slot_depth, mechanism.dimensions.locking_radius,
        mechanism.dimensions.bore_radius, mechanism.dimensions.pin_core_radius})
    EXPECT_FALSE(length);
  EXPECT_EQ(mechanism.motion.acceleration, 0.);
  EXPECT_EQ(mechanism.load.friction_moment, 0.);
  EXPECT_EQ(mechanism.angle_kind, MechanismCase::AngleKind::at_maximum_wheel_acceleration);
  EXPECT_EQ(mechanism.inertia_kind, MechanismCase::InertiaKind::from_geometry);
  expect_same(mechanism.pin, {207e9, 0.3, 7850.});
  expect_same(mechanism.wheel, {207e9, 0.3, 7850.});
}

TEST(MechanismCase, WordsStandForAnglesAndInertias) {
  const auto read = [](const std::string& line) {
    return *CaseDirectory(mechanism_text(line)).read().mechanism;
  };
  EXPECT_EQ(read("set Driver angle = at maximum pin force\n").angle_kind,
            MechanismCase::AngleKind::at_maximum_pin_force);
  EXPECT_EQ(read("set Wheel inertia = Johnson\n").inertia_kind,
            MechanismCase::InertiaKind::johnson);
}

TEST(MechanismCase, TheDriverMayStandAtTheVeryEndOfTheEngagement) {
  const CaseDirectory directory(mechanism_text("set Driver angle = -60 deg\n"));
  expect_same(directory.read().mechanism->driver_angle, -pi / 3.);
}

TEST(MechanismCase, ASolidCylinderGivesTheLoadInertia) {
  const CaseDirectory directory(
      "subsection Mechanism\n set Stations = 6\n set Wheel diameter = 115 mm\n"
      " set Driver speed = 600 rpm\n set Load inertia = solid cylinder\n"
      " set Load diameter = 100 mm\n set Load length = 20 mm\n set Load density = 7850 kg/m^3\n"
      "end\n");
  expect_same(directory.read().mechanism->load.load_inertia, 7850. * pi * 1e-4 * 0.02 / 32.);
}

TEST(MechanismCase, TheCompletedFileGivesTheSameCaseAndCompletesToItself) {
  const std::string cylinder =
      "subsection Mechanism\n set Stations = 12\n set Centre distance = 115 mm\n"
      " set Driver speed = 600 rpm\n set Load inertia = solid cylinder\n"
      " set Load diameter = 100 mm\n set Load length = 20 mm\n set Load density = 7850 kg/m^3\n"
      "end\n";
  for (const std::string& text : {std::string(inch_text), mechanism_text(), cylinder}) {
    const Case given = CaseDirectory(text).read();
    const Case again = CaseDirectory(given.completed).read();
    expect_same(again, given);
    EXPECT_EQ(again.completed, given.completed);
  }
}

TEST(MechanismCase, ALengthWithoutAUnitIsRefusedWithFileLineAndExample) {
  EXPECT_EQ(refusal("set Title = a\n\n\nsubsection Mechanism\n  set Stations = 6\n\n  set Wheel "
                    "diameter = 4.53\nend\n"),
            "DIR/case.prm, line 7: 'Wheel diameter' = '4.53': a length with its unit is wanted, "
            "for example '4.53 in' or '115 mm'");
}

TEST(MechanismCase, AWrongValueIsRefusedWithTheWordsThatAreAllowedToo) {
  EXPECT_EQ(refusal(mechanism_text("set Pin diameter = 15\n")),
            "DIR/case.prm, line 6: 'Pin diameter' = '15': a length with its unit is wanted, for "
            "example '4.53 in' or '115 mm', or 'default'");
  EXPECT_EQ(refusal(mechanism_text("set Wheel inertia = Jonson\n")),
            "DIR/case.prm, line 6: 'Wheel inertia' = 'Jonson': a moment of inertia with its unit "
            "is wanted, for example '0.0046 lbf.s^2.in' or '5e-4 kg.m^2', or one of 'from "
            "geometry', 'Johnson'");
  EXPECT_EQ(refusal(mechanism_text("set Driver angle = 5\n")),
            "DIR/case.prm, line 6: 'Driver angle' = '5': an angle with its unit is wanted, for "
            "example '-11.46 deg' or '-0.2 rad', or one of 'at maximum wheel acceleration', 'at "
            "maximum pin force'");
}

TEST(MechanismCase, ValuesOutOfTheirRangeAreRefused) {
  const auto reason = [](const std::string& line) {
    return refusal("subsection Mechanism\nset " + line + "\nend\n");
  };
  const std::string start = "DIR/case.prm, line 2: ";
  EXPECT_EQ(reason("Wheel diameter = -4 in"),
            start + "'Wheel diameter' = '-4 in': the value must be greater than 0");
  EXPECT_EQ(reason("Wheel diameter = 0 in"),
            start + "'Wheel diameter' = '0 in': the value must be greater than 0");
  EXPECT_EQ(reason("Slot clearance = -1 mm"),
            start + "'Slot clearance' = '-1 mm': the value must be 0 or greater, or 'default'");
  EXPECT_EQ(reason("Driver speed = -600 rpm"),
            start + "'Driver speed' = '-600 rpm': the value must be greater than 0");
  EXPECT_EQ(reason("Friction moment = -1 N.m"),
            start + "'Friction moment' = '-1 N.m': the value must be 0 or greater");
  EXPECT_EQ(reason("Load inertia = -1 kg.m^2"),
            start +
                "'Load inertia' = '-1 kg.m^2': the value must be 0 or greater, or 'solid "
                "cylinder'");
  for (const std::string stations : {"2", "25", "-6"})
    EXPECT_EQ(reason("Stations = " + stations),
              start + "'Stations' = '" + stations + "': the value must be from 3 to 24");
  for (const std::string stations : {"4.5", "600 %", "6 rad", "six", "nan", ""})
    EXPECT_NE(reason("Stations = " + stations).find("a whole number from 3 to 24"),
              std::string::npos)
        << reason("Stations = " + stations);
}

TEST(MechanismCase, MaterialsOutOfTheirRangeAreRefused) {
  const auto reason = [](const std::string& line) {
    return refusal(mechanism_text("subsection Wheel material\nset " + line + "\nend\n"));
  };
  const std::string start = "DIR/case.prm, line 7: 'Wheel material/";
  for (const std::string ratio : {"0.5", "-1", "-2", "50 %"})
    EXPECT_EQ(reason("Poisson's ratio = " + ratio),
              start + "Poisson's ratio' = '" + ratio +
                  "': the value must be greater than -1 and at most 0.4999");
  EXPECT_EQ(reason("Young's modulus = 0 Pa"),
            start + "Young's modulus' = '0 Pa': the value must be greater than 0");
  EXPECT_EQ(reason("Density = 0.283 lbf/in^3"),
            start +
                "Density' = '0.283 lbf/in^3': 'lbf/in^3' is no unit of density ('lbf' and 'N' "
                "are forces: the units of mass are 'lb', 'lbf.s^2/in' and 'kg'); a mass "
                "density with its unit is wanted, for example '0.283 lb/in^3' or "
                "'7850 kg/m^3'");
}

TEST(MechanismCase, SettingsOutOfTheirRangeAreRefused) {
  const std::string start = "DIR/case.prm, line 1: ";
  for (const std::string accuracy : {"0", "-1 %", "0.5", "50 %"})
    EXPECT_EQ(refusal("set Accuracy = " + accuracy + "\n"),
              start + "'Accuracy' = '" + accuracy +
                  "': the value must be greater than 0 and at most 20 %, or 'by dimension'");
  EXPECT_EQ(refusal("set Maximum refinement levels = 29\n"),
            start + "'Maximum refinement levels' = '29': the value must be from 0 to 28");
  EXPECT_EQ(refusal("set Maximum unknowns = 1e10\n"),
            start + "'Maximum unknowns' = '1e10': the value must be from 1 to 2000000000");
  EXPECT_EQ(refusal("set Maximum active-set steps = 0\n"),
            start + "'Maximum active-set steps' = '0': the value must be from 1 to 10000");
  EXPECT_EQ(refusal("set Linear tolerance = 0\n"),
            start + "'Linear tolerance' = '0': the value must be from 1e-15 to 0.001");
  EXPECT_EQ(refusal("set Maximum memory = 0 GB\n"),
            start + "'Maximum memory' = '0 GB': the value must be greater than 0");
  EXPECT_EQ(refusal("set Output units = inch\n"),
            start + "'Output units' = 'inch': one of 'SI', 'mm-N', 'in-lbf' is wanted");
  EXPECT_EQ(refusal("set Model = wheel\n"),
            start + "'Model' = 'wheel': one of 'mechanism', 'geometry', 'synthesis' is wanted");
}

TEST(MechanismCase, MissingParametersAreNamed) {
  EXPECT_EQ(refusal(""),
            "DIR/case.prm: 'Stations' is missing in the subsection 'Mechanism': it takes a whole "
            "number from 3 to 24");
  EXPECT_EQ(
      refusal("subsection Mechanism\n set Stations = 6\n set Wheel diameter = 1 m\n set Load "
              "inertia = 1 kg.m^2\nend\n"),
      "DIR/case.prm: 'Driver speed' is missing in the subsection 'Mechanism': 'Driver motion' "
      "= 'constant' needs it");
  EXPECT_EQ(refusal("subsection Mechanism\n set Stations = 6\n set Driver speed = 6 rpm\nend\n"),
            "DIR/case.prm: 'Load inertia' is missing in the subsection 'Mechanism': it takes a "
            "moment of inertia with its unit, 0 or greater; or 'solid cylinder'; for example "
            "'0.0046 lbf.s^2.in' or '5e-4 kg.m^2'");
}

TEST(MechanismCase, NoSizeOrTwoSizesAreRefused) {
  const std::string start =
      "DIR/case.prm: subsection 'Mechanism': exactly one of 'Wheel diameter', 'Crank radius', "
      "'Centre distance' is wanted; given: ";
  EXPECT_EQ(refusal("subsection Mechanism\n set Stations = 6\n set Driver speed = 6 rpm\n set Load "
                    "inertia = 1 kg.m^2\nend\n"),
            start + "none");
  EXPECT_EQ(refusal(mechanism_text("set Crank radius = 33 mm\n")),
            start + "'Wheel diameter', 'Crank radius'");
}

TEST(MechanismCase, DimensionsThatMakeNoWheelAreRefused) {
  const std::string message = refusal(mechanism_text("set Bore radius = 60 mm\n"));
  EXPECT_EQ(message.find("DIR/case.prm: subsection 'Mechanism': "), 0U) << message;
  EXPECT_NE(message.find("bore"), std::string::npos) << message;
  EXPECT_NE(refusal(mechanism_text("set Slot width = 17 mm\nset Slot clearance = 1 mm\n"))
                .find("are both given"),
            std::string::npos);
}

TEST(MechanismCase, ADriverAngleOutsideTheEngagementIsRefused) {
  EXPECT_EQ(
      refusal(mechanism_text("set Driver angle = -1.2 rad\n")),
      "DIR/case.prm, line 6: 'Driver angle' = '-1.2 rad': driver angle is -68.7549 deg: with 6 "
      "stations the pin is in the slot from -60 deg to 60 deg; choose an angle in this range");
}

TEST(MechanismCase, JohnsonsWheelInertiaIsRefusedBeyondHisTable) {
  EXPECT_EQ(refusal("subsection Mechanism\nset Stations = 12\nset Wheel diameter = 1 m\nset Driver "
                    "speed = 6 rpm\nset Load inertia = 1 kg.m^2\nset Wheel inertia = "
                    "Johnson\nend\n"),
            "DIR/case.prm, line 6: 'Wheel inertia' = 'Johnson': Johnson gives the inertia of "
            "external wheels with 3 to 10 stations, this one is external and has 12; 'from "
            "geometry' or a value is wanted");
}

TEST(MechanismCase, AnIncompleteOrIdleCylinderIsRefused) {
  EXPECT_EQ(refusal(mechanism_text("set Load length = 1 m\n")),
            "DIR/case.prm, line 6: 'Load length' = '1 m': this has no effect unless 'Load inertia' "
            "= 'solid cylinder'");
  EXPECT_EQ(refusal("subsection Mechanism\nset Stations = 6\nset Wheel diameter = 1 m\nset Driver "
                    "speed = 6 rpm\nset Load inertia = solid cylinder\nset Load diameter = 1 "
                    "m\nend\n"),
            "DIR/case.prm: 'Load length' is missing in the subsection 'Mechanism': 'Load inertia' "
            "= 'solid cylinder' needs it");
}

TEST(MechanismCase, ASubsectionOfTheOtherModelIsRefused) {
  EXPECT_EQ(refusal(mechanism_text("", "subsection Geometry\n set Plane = plane stress\nend\n")),
            "DIR/case.prm, line 7: the subsection 'Geometry' belongs to Model = geometry, but this "
            "case has Model = mechanism (default)");
  EXPECT_EQ(refusal(mechanism_text("", "set Model = geometry\n")),
            "DIR/case.prm, line 1: the subsection 'Mechanism' belongs to Model = mechanism, but "
            "this case has Model = geometry");
}

}  // namespace
