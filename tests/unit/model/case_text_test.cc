#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
namespace fs = std::filesystem;

std::string refusal_of_directory(const fs::path& directory) {
  try {
    geneva::model::read_case(directory);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(CaseText, ADirectoryWithoutANameIsRefused) {
  EXPECT_EQ(refusal_of_directory(""),
            "the case directory has no name: name a directory with a case.prm");
}

TEST(CaseText, AMissingDirectoryIsRefused) {
  EXPECT_EQ(refusal_of_directory("no/such/directory"),
            "no/such/directory: there is no such directory");
}

TEST(CaseText, AFileInPlaceOfTheDirectoryIsRefused) {
  const CaseDirectory directory(mechanism_text());
  const std::string file = (directory.path() / "case.prm").string();
  EXPECT_EQ(refusal_of_directory(file),
            file + ": this is not a directory; name the directory that holds case.prm");
}

TEST(CaseText, ADirectoryWithoutACaseFileIsRefused) {
  const CaseDirectory directory("");
  fs::remove(directory.path() / "case.prm");
  EXPECT_EQ(directory.refusal(),
            "DIR: there is no file case.prm in this directory; 'geneva init' writes one");
}

TEST(CaseText, ACaseFileThatIsADirectoryIsRefused) {
  const CaseDirectory directory("");
  fs::remove(directory.path() / "case.prm");
  fs::create_directory(directory.path() / "case.prm");
  EXPECT_EQ(directory.refusal(), "DIR/case.prm: this is not a file that can be read");
}

TEST(CaseText, ASlashAfterTheDirectoryMakesNoDifference) {
  const CaseDirectory directory(mechanism_text());
  EXPECT_EQ(geneva::model::read_case(directory.path() / "").directory, directory.path());
}

TEST(CaseText, AFileOfMoreThanAMegabyteIsRefused) {
  const std::string line(99, '#');
  std::string text = mechanism_text();
  for (int i = 0; i < 10000; ++i) text += line + "\n";
  EXPECT_EQ(refusal(text), "DIR/case.prm: the file is larger than 1 MB: this is no case file");
}

TEST(CaseText, ControlCharactersAreRefused) {
  const std::string reason = " has no place in a text: delete it";
  EXPECT_EQ(refusal(std::string("set Title = a\nset Title = \0b\n", 29)),
            "DIR/case.prm, line 2: the character with the code 0" + reason);
  EXPECT_EQ(refusal("set Title = \x1b[2J\n"),
            "DIR/case.prm, line 1: the character with the code 27" + reason);
  EXPECT_EQ(refusal("set Title = \xc2\x9b"
                    "2J\n"),
            "DIR/case.prm, line 1: the character with the code 155" + reason);
}

TEST(CaseText, TextThatIsNotUtf8IsRefused) {
  for (const char* bytes : {"\xe4", "\xc3", "\xc3(", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                            "\xe2\x82", "\xf0\x80\x80\x80", "\x80"})
    EXPECT_EQ(refusal("\nset Title = " + std::string(bytes)),
              "DIR/case.prm, line 2: this is not UTF-8 text: save the file as UTF-8");
}

TEST(CaseText, TextMayHoldLettersOfAnyLanguageAndWindowsLineEnds) {
  const CaseDirectory directory("\xEF\xBB\xBFset Title = Malteserkreuz größer 歯車 🙂\r\n" +
                                mechanism_text());
  EXPECT_EQ(directory.read().title, "Malteserkreuz größer 歯車 🙂");
}

TEST(CaseText, CommentsAreSkippedAndLongLinesContinued) {
  const CaseDirectory directory(
      "# a comment\nset Title = A long \\ # comment\n   title # and more\n" +
      mechanism_text("  set Pin diameter \\\n = 15 mm\n"));
  const auto given = directory.read();
  EXPECT_EQ(given.title, "A long title");
  EXPECT_DOUBLE_EQ(*given.mechanism->dimensions.pin_diameter, 0.015);
}

TEST(CaseText, AContinuedLineHasTheNumberOfItsFirst) {
  EXPECT_EQ(
      refusal("set Title = a \\\n b\n\nset Accuracy \\\n = 3 mm\n"),
      "DIR/case.prm, line 4: 'Accuracy' = '3 mm': 'mm' does not belong to a plain number; a "
      "plain number or a percentage is wanted, for example '0.3' or '30 %', or 'by dimension'");
}

TEST(CaseText, AContinuedLastLineIsRefused) {
  EXPECT_EQ(refusal("set Title = a \\"),
            "DIR/case.prm, line 1: the last line ends in '\\', but there is no next line");
}

TEST(CaseText, IncludeIsRefused) {
  EXPECT_EQ(refusal("include /etc/passwd\n"),
            "DIR/case.prm, line 1: 'include' is not allowed in a case file");
}

TEST(CaseText, LinesThatAreNoParameterLinesAreRefused) {
  const std::string allowed =
      ": a line is 'set NAME = VALUE', 'subsection NAME', 'end', or a comment after '#'";
  EXPECT_EQ(refusal("Title = x\n"), "DIR/case.prm, line 1: 'Title = x'" + allowed);
  EXPECT_EQ(refusal("subsection Published\nend of it\n"),
            "DIR/case.prm, line 2: 'end of it'" + allowed);
  EXPECT_EQ(refusal("set Title x\n"),
            "DIR/case.prm, line 1: 'set Title x': 'set NAME = VALUE' is wanted");
  EXPECT_EQ(refusal("set = x\n"), "DIR/case.prm, line 1: 'set = x': 'set NAME = VALUE' is wanted");
  EXPECT_EQ(refusal("subsection\n"), "DIR/case.prm, line 1: the subsection has no name");
}

TEST(CaseText, SubsectionsThatAreNotClosedAreRefused) {
  EXPECT_EQ(refusal("subsection Mechanism\n set Stations = 6\n"),
            "DIR/case.prm, line 1: the subsection 'Mechanism' is not closed by 'end'");
  EXPECT_EQ(refusal("set Title = a\nend\n"),
            "DIR/case.prm, line 2: 'end' without a 'subsection' before it");
  EXPECT_EQ(refusal("subsection Mechanism\nsubsection Pin material\nsubsection Wheel material\n"),
            "DIR/case.prm, line 3: there is no subsection 'Wheel material' in 'Pin material': is "
            "an 'end' missing?");
}

TEST(CaseText, AParameterThatIsSetTwiceIsRefused) {
  EXPECT_EQ(refusal(mechanism_text("  set Stations = 8\n")),
            "DIR/case.prm, line 6: 'Stations' has already been set in line 2");
}

TEST(CaseText, AnUnknownParameterIsRefusedWithTheNearestOne) {
  EXPECT_EQ(refusal("set Acuracy = 1 %\n"),
            "DIR/case.prm, line 1: there is no parameter 'Acuracy' outside of all subsections; did "
            "you mean 'Accuracy'?");
  EXPECT_EQ(refusal(mechanism_text("  set pin diamter = 1 mm\n")),
            "DIR/case.prm, line 6: there is no parameter 'pin diamter' in the subsection "
            "'Mechanism'; did you mean 'Pin diameter'?");
  EXPECT_EQ(refusal("subsection Published\n set Colour = blue\nend\n"),
            "DIR/case.prm, line 2: there is no parameter 'Colour' in the subsection 'Published'; "
            "there are 'Peak pressure', 'Source'");
}

TEST(CaseText, AParameterInTheWrongPlaceIsRefusedWithTheRightOne) {
  EXPECT_EQ(refusal("set Driver speed = 600 rpm\n"),
            "DIR/case.prm, line 1: there is no parameter 'Driver speed' outside of all "
            "subsections: it belongs in the subsection 'Mechanism'");
  EXPECT_EQ(refusal(mechanism_text("  set Title = a\n")),
            "DIR/case.prm, line 6: there is no parameter 'Title' in the subsection 'Mechanism': it "
            "belongs outside of all subsections");
}

TEST(CaseText, AnUnknownSubsectionIsRefusedWithTheNearestOrAll) {
  EXPECT_EQ(refusal("subsection Mecanism\nend\n"),
            "DIR/case.prm, line 1: there is no subsection 'Mecanism'; did you mean 'Mechanism'?");
  EXPECT_EQ(refusal("subsection Output\nend\n"),
            "DIR/case.prm, line 1: there is no subsection 'Output'; there are 'Mechanism', "
            "'Optimisation', 'Published', 'Allowable'");
  EXPECT_EQ(refusal(mechanism_text("subsection Driver\nend\n")),
            "DIR/case.prm, line 6: there is no subsection 'Driver' in 'Mechanism'; there are "
            "'Linkage', 'Pin', 'Pin material', 'Stud material', 'Wheel material', 'Design'");
  EXPECT_EQ(refusal("subsection Pin material\nend\n"),
            "DIR/case.prm, line 1: the subsection 'Pin material' belongs into the subsection "
            "'Mechanism'");
}

TEST(CaseText, MessagesAboutLongNamesStayShort) {
  EXPECT_LT(refusal("set " + std::string(900000, 'a') + " = b\n").size(), 500U);
  EXPECT_LT(refusal("set Accuracy = " + std::string(900000, 'a') + "\n").size(), 500U);
  EXPECT_LT(refusal(std::string(900000, 'a') + "\n").size(), 500U);
  EXPECT_LT(refusal("subsection " + std::string(900000, 'a') + "\nend\n").size(), 500U);
}

}  // namespace
