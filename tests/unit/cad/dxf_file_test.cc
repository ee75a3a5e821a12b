#include "cad/dxf_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/wheel/outline_shapes.h"
#include "tests/support/private_directory.h"

namespace geneva::cad {
namespace {

using loads::Outline;
using loads::Point;

/// Half a disc above the x axis with a round hole.
Outline half_disc(const std::string& name, const double radius) {
  const Point left{-radius, 0.};
  const Point right{radius, 0.};
  return {
      name,
      {{loads::line(left, right, "side"), loads::arc(right, {0., radius}, {0., 0.}, false, "arc"),
        loads::arc({0., radius}, left, {0., 0.}, false, "arc")},
       loads::circle({0., radius / 2.}, radius / 4., true, "hole")}};
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& entity) {
  std::size_t found = 0;
  for (std::size_t at = text.find("\n" + entity + "\n"); at != std::string::npos;
       at = text.find("\n" + entity + "\n", at + 1))
    ++found;
  return found;
}

TEST(DxfFile, HasTheAreasThatWereWrittenInEveryUnit) {
  const test::PrivateDirectory directory;
  const std::filesystem::path file = directory.path() / "parts.dxf";
  for (const FileUnit unit : {FileUnit::millimetre, FileUnit::inch}) {
    write_dxf(file, {half_disc("one", 0.1), half_disc("two", 3.)}, unit);
    const auto areas = areas_of_dxf(file, unit);
    const double of_unit_radius = loads::pi / 2. - loads::pi / 16.;
    EXPECT_NEAR(areas.at("one"), of_unit_radius * 0.01, 1e-14);
    EXPECT_NEAR(areas.at("two"), of_unit_radius * 9., 1e-11);
  }
}

TEST(DxfFile, HasTrueArcsAndCircles) {
  const test::PrivateDirectory directory;
  const std::filesystem::path file = directory.path() / "part.dxf";
  write_dxf(file, {half_disc("part", 0.1)}, FileUnit::millimetre);
  const std::string text = text_of(file);
  EXPECT_EQ(count(text, "ARC"), 1U);
  EXPECT_EQ(count(text, "CIRCLE"), 1U);
  EXPECT_EQ(count(text, "LINE"), 1U);
}

TEST(DxfFile, RefusesAChainThatIsOpen) {
  const test::PrivateDirectory directory;
  const std::filesystem::path file = directory.path() / "open.dxf";
  write_dxf(
      file,
      {{"open", {{loads::line({0., 0.}, {1., 0.}, ""), loads::line({1., 0.}, {1., 1.}, "")}}}},
      FileUnit::millimetre);
  EXPECT_THROW(areas_of_dxf(file, FileUnit::millimetre), base::InputError);
}

}  // namespace
}  // namespace geneva::cad
