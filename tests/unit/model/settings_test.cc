#include "model/input/settings.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace {

using geneva::model::Case;
using geneva::model::case_with;
using geneva::model::ParameterText;
using geneva::model::Setting;

ParameterText no_text() {
  ParameterText text;
  text.file = "the new case";
  text.varied_by = "";
  return text;
}

std::vector<Setting> wheel(const std::string& units) {
  const std::vector<std::string> mechanism{"Mechanism"};
  return {{{}, "Output units", units},
          {mechanism, "Stations", std::vector<double>{6.}},
          {mechanism, "Wheel diameter", std::string("120 mm")},
          {mechanism, "Driver speed", std::string("300 rpm")},
          {mechanism, "Load inertia", std::string("0.002 kg.m^2")}};
}

Case wheel_with(const Setting& setting, const std::string& units = "mm-N") {
  std::vector<Setting> settings = wheel(units);
  settings.push_back(setting);
  return case_with(no_text(), settings, std::filesystem::current_path());
}

std::string refusal_of(const Setting& setting) {
  try {
    wheel_with(setting);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

Setting pin_diameter(const double number) {
  return {{"Mechanism"}, "Pin diameter", std::vector<double>{number}};
}

TEST(Settings, ANumberHasTheOutputUnitOfTheCase) {
  EXPECT_DOUBLE_EQ(*wheel_with(pin_diameter(14.)).mechanism->dimensions.pin_diameter, 0.014);
  EXPECT_DOUBLE_EQ(*wheel_with(pin_diameter(0.014), "SI").mechanism->dimensions.pin_diameter,
                   0.014);
  EXPECT_DOUBLE_EQ(*wheel_with(pin_diameter(0.5), "in-lbf").mechanism->dimensions.pin_diameter,
                   0.0127);
}

TEST(Settings, ASettingTakesThePlaceOfWhatTheTextSays) {
  const Case given = wheel_with(pin_diameter(14.));
  const Case changed = case_with(given.text, {pin_diameter(13.)}, given.directory);
  EXPECT_DOUBLE_EQ(*changed.mechanism->dimensions.pin_diameter, 0.013);
  EXPECT_EQ(changed.text.assignments.size(), given.text.assignments.size());
}

TEST(Settings, WhatNoFileCanSayIsRefused) {
  EXPECT_EQ(refusal_of({{}, "Title", std::string("wheel # 6")}),
            "the new case: 'Title' = 'wheel # 6': a value is one line without '#', behind which a "
            "comment stands");
  EXPECT_NE(refusal_of({{}, "Title", std::string("two\nlines")}), "accepted");
  EXPECT_NE(refusal_of({{}, "Title", std::string("set\\")}), "accepted");
  EXPECT_NE(refusal_of({{}, "Title = a", std::string("b")}), "accepted");
}

TEST(Settings, AParameterThatIsSetTwiceIsRefused) {
  EXPECT_EQ(refusal_of({{"Mechanism"}, "Stations", std::string("8")}),
            "the new case: 'Stations' is set twice");
}

TEST(Settings, WrongNumbersAndNamesAreRefusedInTheWordsOfTheReader) {
  EXPECT_EQ(refusal_of(pin_diameter(std::numeric_limits<double>::infinity()))
                .rfind("the new case: 'Pin diameter' = 'inf mm': ", 0),
            0U);
  EXPECT_EQ(refusal_of({{"Mechanism"}, "Pin diametre", std::vector<double>{8.}}),
            "the new case: there is no parameter 'Pin diametre' in the subsection 'Mechanism'; did "
            "you mean 'Pin diameter'?");
}

}  // namespace
