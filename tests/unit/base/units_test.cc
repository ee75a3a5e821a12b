#include "base/units.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace {

using geneva::base::Dimension;
using geneva::base::in_quotes;
using geneva::base::output_unit;
using geneva::base::parse_quantity;
using geneva::base::UnitSystem;

constexpr double pi = 3.14159265358979323846;

std::string refusal(const std::string& text, Dimension dimension) {
  try {
    return "accepted as " + std::to_string(parse_quantity(text, dimension));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Equal to the roundings of a few multiplications.
void expect_same(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-15 * std::abs(expected));
}

TEST(Units, LengthsInInchesMillimetresAndMetresAreTheSame) {
  expect_same(parse_quantity("4.53 in", Dimension::length), 0.115062);
  expect_same(parse_quantity("115.062 mm", Dimension::length), 0.115062);
  expect_same(parse_quantity("0.115062 m", Dimension::length), 0.115062);
  expect_same(parse_quantity("0.3775 ft", Dimension::length), 0.115062);
  expect_same(parse_quantity("115062 µm", Dimension::length), 0.115062);
}

TEST(Units, EveryDimensionTakesTheUnitsThatEngineersWrite) {
  const double inch = 0.0254;
  const double pound = 0.45359237;
  const double pound_force = pound * 9.80665;
  expect_same(parse_quantity("30e6 psi", Dimension::stress), 30e6 * pound_force / (inch * inch));
  expect_same(parse_quantity("207 GPa", Dimension::stress), 207e9);
  expect_same(parse_quantity("207e3 N/mm^2", Dimension::stress), 207e9);
  expect_same(parse_quantity("2 lbf.in", Dimension::moment), 2. * pound_force * inch);
  expect_same(parse_quantity("2 in-lbf", Dimension::moment), 2. * pound_force * inch);
  expect_same(parse_quantity("2 N.m", Dimension::moment), 2.);
  expect_same(parse_quantity("2 N m", Dimension::moment), 2.);
  expect_same(parse_quantity("0.0046 lbf.s^2.in", Dimension::inertia), 0.0046 * pound_force * inch);
  expect_same(parse_quantity("3 lb.in^2", Dimension::inertia), 3. * pound * inch * inch);
  expect_same(parse_quantity("0.283 lb/in^3", Dimension::density),
              0.283 * pound / (inch * inch * inch));
  expect_same(parse_quantity("7.85 g/cm3", Dimension::density), 7850.);
  expect_same(parse_quantity("35 kN/mm", Dimension::force_per_length), 35e6);
  expect_same(parse_quantity("5 lbf", Dimension::force), 5. * pound_force);
  expect_same(parse_quantity("77 kN/m^3", Dimension::force_per_volume), 77e3);
  expect_same(parse_quantity("386.4 in/s^2", Dimension::acceleration), 386.4 * inch);
  expect_same(parse_quantity("16 GB", Dimension::memory), 16e9);
  expect_same(parse_quantity("2 GiB", Dimension::memory), 2147483648.);
}

TEST(Units, AnglesAndAngularSpeedsAreInRadians) {
  expect_same(parse_quantity("-11.46 deg", Dimension::angle), -11.46 * pi / 180.);
  expect_same(parse_quantity("-11.46 °", Dimension::angle), -11.46 * pi / 180.);
  expect_same(parse_quantity("0.2 rad", Dimension::angle), 0.2);
  expect_same(parse_quantity("0.5 rev", Dimension::angle), pi);
  expect_same(parse_quantity("600 rpm", Dimension::angular_speed), 20. * pi);
  expect_same(parse_quantity("600 rev/min", Dimension::angular_speed), 20. * pi);
  expect_same(parse_quantity("3600 deg/s", Dimension::angular_speed), 20. * pi);
  expect_same(parse_quantity("62.8 rad/s", Dimension::angular_speed), 62.8);
  expect_same(parse_quantity("60 rpm/s", Dimension::angular_acceleration), 2. * pi);
}

TEST(Units, PlainNumbersMayBePercentages) {
  expect_same(parse_quantity("0.3", Dimension::dimensionless), 0.3);
  expect_same(parse_quantity("0.5 %", Dimension::dimensionless), 0.005);
  expect_same(parse_quantity("0.5%", Dimension::dimensionless), 0.005);
  expect_same(parse_quantity("2 percent", Dimension::dimensionless), 0.02);
}

TEST(Units, NumbersAreReadInAnyDecimalNotation) {
  for (const char* text : {"4.5mm", "  4.5   mm ", "+4.5 mm", "45e-1 mm", ".45E+1mm", "4500 um"})
    expect_same(parse_quantity(text, Dimension::length), 0.0045);
  expect_same(parse_quantity("-4.5 mm", Dimension::length), -0.0045);
}

TEST(Units, AMissingUnitIsRefused) {
  EXPECT_EQ(refusal("4.53", Dimension::length),
            "'4.53': a length with its unit is wanted, for example '4.53 in' or '115 mm'");
  EXPECT_EQ(refusal("5", Dimension::angle),
            "'5': an angle with its unit is wanted, for example '-11.46 deg' or '-0.2 rad'");
  EXPECT_EQ(refusal("600", Dimension::angular_speed),
            "'600': an angular speed with its unit is wanted, for example '600 rpm' or "
            "'62.8 rad/s'");
  EXPECT_EQ(refusal("16", Dimension::memory),
            "'16': an amount of memory with its unit is wanted, for example '16 GB' or '500 MB'");
  EXPECT_EQ(refusal("0", Dimension::moment),
            "'0': a moment with its unit is wanted, for example '2 lbf.in' or '0.2 N.m'");
}

TEST(Units, AMissingNumberIsRefused) {
  for (const char* text : {"", " ", "mm", "- mm", "+-1 mm", "++1 mm", ".mm", "e5 mm"})
    EXPECT_EQ(
        refusal(text, Dimension::length),
        in_quotes(text) + ": a length with its unit is wanted, for example '4.53 in' or '115 mm'");
}

TEST(Units, AnUnknownUnitIsRefused) {
  for (const char* unit : {"inchs", "Mm.", "m/", "(m", "m,", "m^", "m^2^2", "m^300", "mm\x01"})
    EXPECT_EQ(refusal("5 " + std::string(unit), Dimension::length),
              in_quotes("5 " + std::string(unit)) + ": " + in_quotes(unit) +
                  " is no unit known here; a length with its unit is wanted, for example "
                  "'4.53 in' or '115 mm'");
  EXPECT_EQ(refusal("2 Nm", Dimension::moment),
            "'2 Nm': 'Nm' is no unit known here (did you mean 'N.m'?); a moment with its unit is "
            "wanted, for example "
            "'2 lbf.in' or '0.2 N.m'");
  EXPECT_EQ(refusal("16 Gb", Dimension::memory),
            "'16 Gb': 'Gb' is no unit of memory known here; an amount of memory with its unit is "
            "wanted, for example '16 GB' or '500 MB'");
  EXPECT_EQ(refusal(std::string("5 m\0m", 5), Dimension::length), "'5 m");
}

TEST(Units, ASecondNumberIsRefusedInsteadOfMultiplied) {
  for (const char* text :
       {"5 2 mm", "5 in 2", "5 in.2", "5 in/2", "5 in*2", "5 (2 in)", "5 in -2", "5 1e3 m"})
    EXPECT_NE(refusal(text, Dimension::length).find("is no unit known here"), std::string::npos)
        << refusal(text, Dimension::length);
  EXPECT_EQ(
      refusal("600 1/min", Dimension::angular_speed),
      "'600 1/min': '1/min' is no unit known here (did you mean 'rpm'?); an angular speed with "
      "its unit is wanted, for example '600 rpm' or '62.8 rad/s'");
}

TEST(Units, AHardnessIsANumberOfVickersOrBrinell) {
  EXPECT_EQ(refusal("58 HRC", Dimension::dimensionless),
            "'58 HRC': 'HRC' does not belong to a plain number (a hardness is Vickers' or "
            "Brinell's number: 58 HRC is about 650); a plain number or a percentage is wanted, for "
            "example '0.3' or '30 %'");
  EXPECT_NE(refusal("700 HV", Dimension::dimensionless).find("as its number alone"),
            std::string::npos);
}

TEST(Units, AUnitOfAnotherDimensionIsRefused) {
  EXPECT_EQ(refusal("4.53 s", Dimension::length),
            "'4.53 s': 's' is no unit of length; a length with its unit is wanted, for example "
            "'4.53 in' or '115 mm'");
  EXPECT_EQ(refusal("5 pa", Dimension::stress),
            "'5 pa': 'pa' is no unit of stress; a stress with its unit is wanted, for example "
            "'30e6 psi' or '207 GPa'");
  EXPECT_EQ(refusal("5 deg", Dimension::dimensionless),
            "'5 deg': 'deg' does not belong to a plain number; a plain number or a percentage is "
            "wanted, for example '0.3' or '30 %'");
  for (const char* text : {"5 bit", "5 byte", "5 rad", "5 m/m"})
    EXPECT_NE(refusal(text, Dimension::dimensionless).find("does not belong to a plain number"),
              std::string::npos);
  EXPECT_NE(refusal("2 N.m/rad", Dimension::moment).find("no unit of moment"), std::string::npos);
  EXPECT_NE(refusal("2 sr", Dimension::angle).find("no unit of angle"), std::string::npos);
}

TEST(Units, HertzIsNoAngularSpeedSinceItCouldBeTurnsOrRadians) {
  for (const std::string unit : {"Hz", "s-1", "/s"})
    EXPECT_NE(refusal("10 " + unit, Dimension::angular_speed).find("accepted"), 0U);
  EXPECT_EQ(refusal("10 Hz", Dimension::angular_speed),
            "'10 Hz': 'Hz' is no unit of angular speed (turns or radians? write 'rpm', 'rad/s' or "
            "'deg/s'); an angular speed with its unit is wanted, for example '600 rpm' or "
            "'62.8 rad/s'");
}

TEST(Units, AMassWhereAForceBelongsIsRefusedWithAHint) {
  const std::string hint =
      " ('lb' and 'kg' are masses: the units of force are 'lbf', 'kgf' and 'N')";
  EXPECT_EQ(refusal("2 lb.in", Dimension::moment),
            "'2 lb.in': 'lb.in' is no unit of moment" + hint +
                "; a moment with its unit is wanted, for example '2 lbf.in' or '0.2 N.m'");
  EXPECT_NE(refusal("5 lb", Dimension::force).find(hint), std::string::npos);
  EXPECT_NE(refusal("5 kg/mm^2", Dimension::stress).find(hint), std::string::npos);
  EXPECT_NE(refusal("5 lb.s^2.in", Dimension::inertia).find(hint), std::string::npos);
}

TEST(Units, AForceWhereAMassBelongsIsRefusedWithAHint) {
  EXPECT_EQ(refusal("0.283 lbf/in^3", Dimension::density),
            "'0.283 lbf/in^3': 'lbf/in^3' is no unit of density ('lbf' and 'N' are forces: the "
            "units of mass are 'lb', 'lbf.s^2/in' and 'kg'); a mass density with its unit is "
            "wanted, for example '0.283 lb/in^3' or '7850 kg/m^3'");
}

TEST(Units, UnitsWithAnOffsetALogarithmOrADateAreRefused) {
  for (const char* unit : {"m @ 5", "m from 5", "m since 2000-01-01", "lg(re m)", "degC"})
    EXPECT_NE(refusal("5 " + std::string(unit), Dimension::length).find("is no unit"),
              std::string::npos)
        << refusal("5 " + std::string(unit), Dimension::length);
}

TEST(Units, ANumberThatIsNotFiniteIsRefused) {
  for (const char* text : {"inf m", "-inf m", "nan m", "infinity m", "nan(1) m"})
    EXPECT_NE(refusal(text, Dimension::length).find("the number is not finite"), std::string::npos)
        << refusal(text, Dimension::length);
  EXPECT_NE(refusal("1e999 m", Dimension::length).find("the number is too large or too small"),
            std::string::npos);
  EXPECT_NE(refusal("1e308 km", Dimension::length).find("the value is too large"),
            std::string::npos);
}

TEST(Units, ADecimalCommaIsRefusedWithAHint) {
  EXPECT_EQ(refusal("4,53 in", Dimension::length),
            "'4,53 in': a decimal number is written with a point; a length with its unit is "
            "wanted, for example '4.53 in' or '115 mm'");
}

TEST(Units, HexadecimalNumbersAreRefused) {
  EXPECT_NE(refusal("0x10 m", Dimension::length).find("'x10 m' is no unit"), std::string::npos);
}

TEST(Units, LongTextsAreCutInMessagesBetweenCharacters) {
  const std::string message = refusal("5 " + std::string(100000, 'm'), Dimension::length);
  EXPECT_LT(message.size(), 400U);
  std::string text(99, 'a');
  text += "é";
  EXPECT_EQ(in_quotes(text), "'" + std::string(99, 'a') + "...'");
  EXPECT_EQ(in_quotes(std::string(100, 'a')), "'" + std::string(100, 'a') + "'");
}

TEST(Units, OutputUnitsAreThoseOfTheirSystem) {
  EXPECT_EQ(output_unit(UnitSystem::si, Dimension::stress).name, "Pa");
  EXPECT_EQ(output_unit(UnitSystem::si, Dimension::stress).factor, 1.);
  EXPECT_EQ(output_unit(UnitSystem::mm_newton, Dimension::stress).name, "MPa");
  expect_same(output_unit(UnitSystem::mm_newton, Dimension::stress).factor, 1e-6);
  EXPECT_EQ(output_unit(UnitSystem::mm_newton, Dimension::length).factor, 1000.);
  EXPECT_EQ(output_unit(UnitSystem::inch_pound, Dimension::stress).name, "psi");
  expect_same(output_unit(UnitSystem::inch_pound, Dimension::stress).factor,
              1. / 6894.757293168361);
  EXPECT_EQ(output_unit(UnitSystem::inch_pound, Dimension::inertia).name, "lbf.s^2.in");
}

TEST(Units, AnOutputUnitCanBeReadBack) {
  for (const UnitSystem system : {UnitSystem::si, UnitSystem::mm_newton, UnitSystem::inch_pound}) {
    for (int i = 0; i <= static_cast<int>(Dimension::memory); ++i) {
      const auto dimension = static_cast<Dimension>(i);
      const auto [name, factor] = output_unit(system, dimension);
      expect_same(factor * parse_quantity("7.5 " + name, dimension), 7.5);
    }
  }
}

TEST(Units, EveryExampleOfAMessageIsAccepted) {
  for (int i = 0; i <= static_cast<int>(Dimension::memory); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    const std::string examples = geneva::base::example_of(dimension);
    const std::size_t middle = examples.find("' or '");
    ASSERT_NE(middle, std::string::npos);
    EXPECT_NO_THROW(parse_quantity(examples.substr(1, middle - 1), dimension));
    EXPECT_NO_THROW(
        parse_quantity(examples.substr(middle + 6, examples.size() - middle - 7), dimension));
    EXPECT_FALSE(geneva::base::name_of(dimension).empty());
    EXPECT_FALSE(geneva::base::wanted(dimension).empty());
  }
}

}  // namespace
