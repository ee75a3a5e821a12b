#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "model/input/case_file.h"
#include "model/input/nearest_word.h"
#include "model/input/parameter_listing.h"
#include "model/input/parameters.h"

namespace {

using namespace geneva::model;
using geneva::base::Dimension;

std::string printed() {
  std::ostringstream stream;
  stream << parameter_file();
  return stream.str();
}

std::vector<Parameter> all_parameters() {
  std::vector<Parameter> all = general_parameters();
  for (const auto& more : {settings_parameters(), mechanism_parameters(),
                           geometry_parameters({"a"}, {"b"}, {"Surface c"}, ""),
                           synthesis_parameters(), published_parameters()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(Parameters, ThePrintedFileIsAlwaysTheSameAndHasNoPaths) {
  const std::string text = printed();
  EXPECT_EQ(printed(), text);
  EXPECT_EQ(text.find(std::filesystem::current_path().string()), std::string::npos);
  EXPECT_EQ(text.find("/home"), std::string::npos);
  EXPECT_EQ(text.find("/tmp"), std::string::npos);
}

TEST(Parameters, ThePrintedFileHasEverySubsection) {
  const std::string text = printed();
  for (const char* line :
       {"\nsubsection Mechanism\n", "\n  subsection Pin material\n",
        "\n  subsection Wheel material\n", "\n  subsection Design\n", "\nsubsection Geometry\n",
        "\n  subsection Body NAME\n", "\n  subsection Load NAME\n", "\nsubsection Synthesis\n",
        "\nsubsection Published\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
}

TEST(Parameters, EveryParameterHasAnExplanationAndADefaultThatItsRuleAllows) {
  for (const Parameter& parameter : all_parameters()) {
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
    EXPECT_EQ(parameter.help.back(), '.') << parameter.name;
    EXPECT_EQ(parameter.help.find('\\'), std::string::npos) << parameter.name;
    if (parameter.required)
      EXPECT_TRUE(parameter.default_value.empty()) << parameter.name;
    else
      EXPECT_FALSE(refusal(parameter.rule, parameter.default_value)) << parameter.name;
  }
}

TEST(Parameters, RulesSayWhatTheyAllow) {
  QuantityRule rule;
  rule.dimension = Dimension::length;
  EXPECT_EQ(allowed(rule), "A length with its unit.");
  rule.range = greater_than_zero();
  EXPECT_EQ(allowed(rule), "A length with its unit, greater than 0.");
  rule.words = {"", "default"};
  EXPECT_EQ(allowed(rule), "A length with its unit, greater than 0; or 'default'.");
  rule.count = 2;
  EXPECT_EQ(allowed(rule),
            "2 values separated by commas, each a length with its unit, greater than 0; or "
            "'default'.");
  EXPECT_EQ(allowed(ChoiceRule{{"a", "b"}}), "One of 'a', 'b'.");
  EXPECT_EQ(allowed(TextRule{"any text"}), "Any text.");
}

TEST(Parameters, AQuantityRuleRefusesWhatIsOutsideOfIt) {
  QuantityRule rule;
  rule.dimension = Dimension::length;
  rule.range = greater_than_zero();
  rule.words = {"default"};
  for (const char* text : {"5 mm", "4.53 in", "default"}) EXPECT_FALSE(refusal(rule, text)) << text;
  for (const char* text : {"", "5", "0 mm", "-5 mm", "5 s", "Default", "5 mm, 5 mm"})
    EXPECT_TRUE(refusal(rule, text)) << text;
}

TEST(Parameters, AListingNamesTheDefaultBehindAnotherValue) {
  const Parameter first{{}, "First", "1", TextRule{"any text"}, "What it is."};
  const Parameter second{{"Outer", "Inner"},   "Second one", "",
                         TextRule{"any text"}, "It too.",    true};
  const auto text_with = [&](const bool is_given) {
    return parameter_listing(
        {first, second},
        [](const Parameter& parameter) {
          return parameter.name == "First" ? std::string("another") : parameter.default_value;
        },
        [&](const Parameter&) { return is_given; });
  };
  const std::string text = text_with(false);
  EXPECT_NE(text_with(true).find("set Second one =  # default: \n"), std::string::npos)
      << "what is given is marked, be it the default or not";
  EXPECT_EQ(text,
            "# Listing of Parameters\n# ---------------------\n"
            "# What it is. [Any text.]\nset First = another # default: 1\n\n\n"
            "subsection Outer\n  subsection Inner\n"
            "    # Required. It too. [Any text.]\n    set Second one = \n  end\n\nend\n\n\n");
}

TEST(Parameters, AListingFillsItsLines) {
  const Parameter parameter{{"S"},
                            "P",
                            "",
                            TextRule{"any text"},
                            std::string(40, 'a') + " " + std::string(33, 'b') + " c"};
  const std::string text = parameter_listing(
      {parameter}, [](const Parameter&) { return ""; }, [](const Parameter&) { return false; });
  EXPECT_NE(text.find("  # " + std::string(40, 'a') + " " + std::string(33, 'b') +
                      "\n  # c [Any text.]\n"),
            std::string::npos)
      << "a line takes 78 characters, one of 79 is broken:\n"
      << text;
}

TEST(Parameters, TheNearestWordIsTheOneWithTheLeastEdits) {
  const std::vector<std::string> words{"Slot width", "Slot depth", "Stations"};
  EXPECT_EQ(nearest_word("Slot wdith", words), "Slot width");
  EXPECT_EQ(nearest_word("slot depth", words), "Slot depth");
  EXPECT_EQ(nearest_word("station", words), "Stations");
  EXPECT_FALSE(nearest_word("Colour", words));
  EXPECT_FALSE(nearest_word("", words));
  EXPECT_FALSE(nearest_word(std::string(1000, 'a'), words));
}

TEST(Parameters, ABeginningStandsForTheOnlyWordThatHasIt) {
  const std::vector<std::string> words{"Slot width", "Slot depth", "Stations"};
  EXPECT_EQ(nearest_word("stat", words), "Stations");
  EXPECT_EQ(nearest_word("Slot w", words), "Slot width");
  EXPECT_FALSE(nearest_word("Slot", words));
  EXPECT_FALSE(nearest_word("St", words));
  EXPECT_EQ(nearest_word("Width", words), "Slot width");
  EXPECT_FALSE(nearest_word("idth", words)) << "no word of its own";
}

}  // namespace
