#include "model/input/case_content.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace geneva::model {
namespace {

const std::string text =
    "set Model = mechanism\nset Title = one # a comment\nset Output units = SI\n"
    "subsection Mechanism\n  set Stations = 4\n  subsection Pin\n    set Tilt = 0 deg\n  end\nend\n"
    "subsection Allowable\n  set Contact pressure = 1 GPa\nend\n";

std::string with(const std::string& old, const std::string& changed) {
  std::string result = text;
  result.replace(result.find(old), old.size(), changed);
  return result;
}

std::string mark(const std::string& of) { return content_of(of, "mechanism", {}); }

TEST(ContentOf, LeavesOutWhatDoesNotChangeTheMechanism) {
  EXPECT_EQ(mark(with("one", "two")), mark(text)) << "title";
  EXPECT_EQ(mark(with("= SI", "= mm-N")), mark(text)) << "units";
  EXPECT_EQ(mark(with("a comment", "another")), mark(text)) << "comment";
  EXPECT_EQ(mark(with("1 GPa", "2 GPa")), mark(text)) << "allowable";
}

TEST(ContentOf, ChangesWithMechanismAndFiles) {
  EXPECT_NE(mark(with("= 4", "= 5")), mark(text));
  EXPECT_NE(mark(with("0 deg", "1 deg")), mark(text));
  EXPECT_NE(content_of(text, "geometry", {}), mark(text));
  const auto file = std::filesystem::path(testing::TempDir()) / "content-table.csv";
  std::ofstream(file) << "1, 2";
  const std::string before = content_of(text, "mechanism", {file});
  EXPECT_NE(before, mark(text));
  std::ofstream(file) << "1, 3";
  EXPECT_NE(content_of(text, "mechanism", {file}), before);
  std::filesystem::remove(file);
}

TEST(ContentOf, IsSixteenHexadecimalDigits) {
  EXPECT_EQ(mark(text).find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(mark(text).size(), 16U);
}

}  // namespace
}  // namespace geneva::model
