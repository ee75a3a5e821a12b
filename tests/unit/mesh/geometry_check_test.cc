#include "mesh/geometry_check.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;

TEST(GeometryCheck, RefusesCommandsThatHarmWithFileAndLine) {
  for (const char* const word : {"SystemCall", "NonBlockingSystemCall", "Save", "Print", "Exit"})
    expect_refused(
        [&] { check_geometry("x = 1;\n\n" + std::string(word) + " \"y\";\n", "wheel.geo"); },
        {"wheel.geo:3:", word, "may draw, mesh"});
}

TEST(GeometryCheck, KnowsWordsFromCommentsTextsAndOtherWords) {
  EXPECT_NO_THROW(
      check_geometry("// SystemCall\n/* Save */ Printf(\"Exit\"); Exit1 = 2; _Save = 3;"
                     "Physical Curve('Print') = {1};\n",
                     "wheel.geo"));
}

TEST(GeometryCheck, CountsLinesAcrossCommentsAndTexts) {
  expect_refused([] { check_geometry("/* a\nb */ // c\n \"d\n\" Save\n", "wheel.geo"); },
                 {"wheel.geo:4:"});
}

TEST(GeometryCheck, RefusesALastLineThatGmshWouldLeaveOut) {
  expect_refused([] { check_geometry("x = 1;\ny = 2;", "wheel.geo"); },
                 {"wheel.geo:2:", "last line has no end"});
  EXPECT_NO_THROW(check_geometry("x = 1;\n  ", "wheel.geo"));
  EXPECT_NO_THROW(check_geometry("", "wheel.geo"));
}

TEST(GeometryCheck, FindsTheNamesOfFilesThatAreRead) {
  EXPECT_EQ(check_geometry("Include \"a.geo\";\nMerge 'b/c.msh'; // Include \"d\"\nx = \"e\";\n",
                           "wheel.geo"),
            (std::vector<std::string>{"a.geo", "b/c.msh"}));
}

}  // namespace
}  // namespace geneva::mesh
