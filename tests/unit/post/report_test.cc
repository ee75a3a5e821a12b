#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/chart.h"
#include "post/report/pictures/picture.h"
#include "post/report/results/case_inputs.h"
#include "post/report/results/csv_table.h"
#include "post/view/hexahedron_cut.h"
#include "post/view/quantised.h"

namespace {

using namespace geneva::post;

using Place = std::array<double, 3>;

Place corner(const unsigned int index) {
  const auto bit = [&](const unsigned int i) { return index & (1U << i) ? 1. : 0.; };
  return {bit(0), bit(1), bit(2)};
}

Place place(const EdgePoint& point) {
  const Place a = corner(point.first);
  const Place b = corner(point.second);
  Place result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] + point.fraction * (b[i] - a[i]);
  return result;
}

double area(const std::array<EdgePoint, 3>& triangle) {
  Place a = place(triangle[1]);
  Place b = place(triangle[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] -= place(triangle[0])[i];
    b[i] -= place(triangle[0])[i];
  }
  return 0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]);
}

/// Area of the unit cube's cut by the plane n x = c.
double cut_area(const Place& n, const double c) {
  std::array<double, 8> distances{};
  for (unsigned int i = 0; i < 8; ++i)
    distances[i] = n[0] * corner(i)[0] + n[1] * corner(i)[1] + n[2] * corner(i)[2] - c;
  double sum = 0.;
  for (const auto& triangle : cut_hexahedron(distances)) {
    sum += area(triangle);
    for (const EdgePoint& point : triangle) {
      const Place at = place(point);
      EXPECT_NEAR(n[0] * at[0] + n[1] * at[1] + n[2] * at[2], c, 1e-14);
    }
  }
  return sum;
}

TEST(HexahedronCut, HasTheAreaOfThePlaneWithinTheCube) {
  EXPECT_NEAR(cut_area({0., 0., 1.}, 0.3), 1., 1e-14);
  EXPECT_NEAR(cut_area({1., 0., 0.}, 0.9), 1., 1e-14);
  EXPECT_NEAR(cut_area({1., 1., 0.}, 1.), std::sqrt(2.), 1e-14);
  EXPECT_NEAR(cut_area({1., 1., 1.}, 1.5), 0.75 * std::sqrt(3.), 1e-14);  // a regular hexagon
  EXPECT_NEAR(cut_area({1., 1., 1.}, 0.5), 0.125 * std::sqrt(3.), 1e-14);
}

TEST(HexahedronCut, IsEmptyBesideTheCube) {
  EXPECT_EQ(cut_area({0., 0., 1.}, 1.1), 0.);
  EXPECT_EQ(cut_area({0., 0., 1.}, -0.1), 0.);
}

TEST(EncodedNumbers, ComeBack) {
  const std::vector<float> numbers{0.F, -1.5F, 3.25e-30F};
  EXPECT_EQ(geneva::base::decoded<float>(geneva::base::encoded(numbers)), numbers);
  EXPECT_EQ(geneva::base::encoded(std::vector<unsigned int>{1}), "AQAAAA==");
  EXPECT_TRUE(geneva::base::decoded<float>("").empty());
}

TEST(QuantisedNumbers, KeepTheirEndsAndGapsAndFourDigits) {
  const std::vector<float> numbers{-3.F, NAN, 0.1F, 7.F};
  const std::vector<float> back = restored(quantised(numbers));
  EXPECT_EQ(back[0], -3.F);
  EXPECT_TRUE(std::isnan(back[1]));
  EXPECT_NEAR(back[2], 0.1, 1e-4);
  EXPECT_EQ(back[3], 7.F);
  EXPECT_EQ(restored(quantised({2.F, 2.F})), (std::vector<float>{2.F, 2.F}));
}

TEST(EncodedNumbers, RefuseWhatIsDamaged) {
  EXPECT_THROW(geneva::base::decoded<float>("AQAA"), std::invalid_argument);
  EXPECT_THROW(geneva::base::decoded<float>("!!!!"), std::invalid_argument);
}

TEST(Html, EscapesMarkup) {
  EXPECT_EQ(escaped("<b title=\"x\">it's & more</b>"),
            "&lt;b title=&quot;x&quot;&gt;it&#39;s &amp; more&lt;/b&gt;");
}

TEST(Picture, PaintsPixelsWhoseMiddleTheTriangleCovers) {
  const Colour white{255, 255, 255};
  Picture picture(4, 4, white);
  picture.paint({{{0., 0., 0.}, {4., 0., 0.}, {0., 4., 0.}}});
  EXPECT_EQ(picture.at(0, 0), (Colour{0x44, 0x01, 0x54}));
  EXPECT_EQ(picture.at(2, 1), (Colour{0x44, 0x01, 0x54}));
  EXPECT_EQ(picture.at(3, 3), white);
  EXPECT_EQ(picture.at(2, 2), white);
}

TEST(Picture, RunsThroughThePaletteFromEndToEnd) {
  EXPECT_EQ(colour_of(-1.), (Colour{0x44, 0x01, 0x54}));
  EXPECT_EQ(colour_of(2.), (Colour{0xfd, 0xe7, 0x25}));
  Picture picture(100, 1, {255, 255, 255});
  picture.paint({{{0., -1., 0.}, {200., -1., 2.}, {0., 2., 0.}}});
  EXPECT_EQ(picture.at(50, 0)[1], colour_of(0.505)[1]);
}

TEST(Picture, IsAPngFile) {
  const auto bytes = Picture(3, 2, {1, 2, 3}).png();
  const std::vector<unsigned char> signature{0x89, 'P', 'N', 'G'};
  EXPECT_EQ(std::vector<unsigned char>(bytes.begin(), bytes.begin() + 4), signature);
}

TEST(ShownValues, KeepTheirDigitsWithoutPowersOfTen) {
  EXPECT_EQ(significant(118578.3, 5), "118\u202f580");
  EXPECT_EQ(significant(-72774.9, 5), "-72\u202f775");
  EXPECT_EQ(significant(72774.9, 4), "72\u202f770");
  EXPECT_EQ(significant(0.00299231, 5), "0.0029923");
  EXPECT_EQ(significant(5.01765e8, 5), "501\u202f770\u202f000");
  EXPECT_EQ(significant(5.01723e9, 5), "5\u202f017\u202f200\u202f000");
  EXPECT_EQ(significant(5.01723e12, 5), "5.0172e+12");
  EXPECT_EQ(significant(999.7, 3), "1000");
  EXPECT_EQ(significant(1471.34, 5), "1471.3") << "four digits stay together";
  EXPECT_EQ(significant(0., 5), "0");
}

TEST(ShownValues, ShowInputsAsPrintHasThem) {
  EXPECT_EQ(shown_input("4.52661449 in"), "4.52661 in");
  EXPECT_EQ(shown_input("30e6 psi"), "30\u202f000\u202f000 psi");
  EXPECT_EQ(shown_input("4 N.m"), "4 N·m");
  EXPECT_EQ(shown_input("0 m/s^2, 10471.9755 m/s^2"), "0 m/s², 10\u202f472 m/s²");
  EXPECT_EQ(shown_input("1 in x 3 in"), "1 in x 3 in");
  EXPECT_EQ(shown_input("pin.csv"), "pin.csv");
}

TEST(CaseInputs, AreGivenWhereTheirDefaultStandsBehindThem) {
  const std::string text =
      "# text\nset Title = a # default: \nsubsection Outer\n  subsection Inner\n"
      "    set Ratio = 0.30000001 # default: 0.3\n    set Other = 1\n  end\n"
      "  subsection Idle\n    set Nothing = 2\n  end\n  set Last = 3   # default: 3\nend\n";
  const std::vector<CaseInput> inputs = case_inputs(text);
  ASSERT_EQ(inputs.size(), 5U);
  EXPECT_EQ(inputs[1].name, "Inner/Ratio");
  EXPECT_TRUE(inputs[1].is_given);
  EXPECT_FALSE(inputs[2].is_given);
  EXPECT_TRUE(inputs[4].is_given);
  EXPECT_FALSE(inputs[4].is_published);
  EXPECT_TRUE(
      case_inputs("subsection Published\n  set Peak pressure = 1 Pa\nend\n")[0].is_published);
  EXPECT_EQ(given_lines(text),
            "set Title = a\nsubsection Outer\n  subsection Inner\n    set Ratio = 0.30000001\n"
            "  end\n  set Last = 3\nend\n");
}

TEST(ShownValues, HaveNoMarksBetweenNumbersThatDifferByRounding) {
  EXPECT_TRUE(round_numbers(655.44, 655.44 * (1. + 1e-15), 5).empty());
  EXPECT_TRUE(round_numbers(1., 1., 5).empty());
}

TEST(ShownValues, AreMarkedAtRoundNumbers) {
  EXPECT_EQ(round_numbers(0.3, 5.2, 5), (std::vector<double>{1., 2., 3., 4., 5.}));
  EXPECT_EQ(round_numbers(-30., 40., 8),
            (std::vector<double>{-30., -20., -10., 0., 10., 20., 30., 40.}));
}

TEST(Chart, TellsMissingValuesAsNull) {
  const Chart chart{"c", "", "", {"x"}, {"y", true}, {{"s", SeriesStyle::dashed, {{1., NAN}}}}};
  const nlohmann::json json = to_json(chart);
  EXPECT_EQ(json["series"][0]["points"].dump(), "[[1.0,null]]");
  EXPECT_EQ(json["series"][0]["style"], "dashed");
  EXPECT_EQ(json["y"]["logarithmic"], true);
}

class CsvTableOf : public testing::Test {
 protected:
  CsvTable read(const std::string& text) {
    const auto file = std::filesystem::path(testing::TempDir()) / "geneva_table.csv";
    std::ofstream(file) << text;
    return read_csv(file);
  }
};

TEST_F(CsvTableOf, NumbersAndWordsHasUnitsAndGaps) {
  const CsvTable table = read("pair,x [mm],p [MPa]\na -> b,1.5,\nc -> d,2,3e2\n");
  EXPECT_EQ(table.n_rows(), 2);
  EXPECT_EQ(table.column("x").unit, "mm");
  EXPECT_TRUE(std::isnan(table.column("p").values[0]));
  EXPECT_EQ(table.rows_with("pair", "c -> d").column("p").values, std::vector<double>{300.});
  EXPECT_THROW(static_cast<void>(table.column("q")), std::invalid_argument);
}

TEST_F(CsvTableOf, UnevenRowsIsRefused) {
  EXPECT_THROW(read("a,b\n1,2\n3\n"), std::invalid_argument);
}

}  // namespace
