#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "post/output/sweep_output.h"
#include "post/report/pictures/map_picture.h"

namespace geneva::post {
namespace {

using base::Dimension;

SweepFigure figure(const std::string& name, const double value) {
  return {name, Dimension::dimensionless, value, std::nullopt, std::nullopt};
}

/// Two points of which the figures "a" to "g" change by less and less, and "peak contact pressure"
/// not at all.
SweepReport sweep_of_nine_figures() {
  SweepReport report{{}, "", "run", {"Mechanism/Pin diameter"}, {}, {}};
  for (const double share : {0., 1.}) {
    SweepPoint point{{share == 0. ? "1 mm" : "2 mm"}, "", 0, "", {}};
    for (const char letter : {'a', 'b', 'c', 'd', 'e', 'f', 'g'})
      point.figures.push_back(figure(std::string(1, letter), 10. + share * ('z' - letter)));
    point.figures.push_back(figure("peak contact pressure", 5.));
    point.figures.push_back(figure("safety factor: a", 1. + 100. * share));
    point.figures.push_back(figure("least safety factor", 1.));
    report.points.push_back(point);
  }
  return report;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(SweepTable, ShowsPeakPressureLeastFactorAndWhatChangesMost) {
  const std::string heading =
      first_line(sweep_table(sweep_of_nine_figures(), base::UnitSystem::mm_newton));
  std::istringstream words(heading);
  std::vector<std::string> columns;
  for (std::string word; words >> word;) columns.push_back(word);
  const std::vector<std::string> expected{"Pin",   "diameter", "[mm]",   "a",       "b",
                                          "c",     "d",        "peak",   "contact", "pressure",
                                          "least", "safety",   "factor", "of"};
  EXPECT_EQ(columns, expected);
}

TEST(SweepTable, KeepsTheOrderOfTheFigures) {
  SweepReport report = sweep_of_nine_figures();
  for (SweepPoint& point : report.points)
    point.figures.erase(point.figures.begin(), point.figures.begin() + 4);
  EXPECT_LT(first_line(sweep_table(report, base::UnitSystem::mm_newton)).find(" e "),
            first_line(sweep_table(report, base::UnitSystem::mm_newton)).find(" f "));
}

/// Texts of a map's axis of places: those that stand below the cells.
std::size_t n_texts(const std::string& svg) {
  std::size_t found = 0;
  for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1))
    ++found;
  return found;
}

TEST(MapPicture, LeavesOutNumbersThatHaveNoRoomAtItsAxes) {
  MapData map;
  constexpr int n = 60;
  for (int i = 0; i < n; ++i) {
    map.x.push_back(i);
    map.y.push_back(i);
    for (int j = 0; j < n; ++j) map.values.push_back(i + j);
  }
  const std::size_t texts = n_texts(map_picture(map, "bar"));
  EXPECT_LT(texts, 60U);
  EXPECT_GT(texts, 15U);
}

}  // namespace
}  // namespace geneva::post
