#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
namespace fem = geneva::fem;

std::string case_text(const std::string& lines) {
  return R"(
set Model = geometry
subsection Geometry
  set Length unit = mm
  set Thickness = 1 mm
  set Bodies = one, other
  set Loads = top, core, lid
  set Supports = bottom: fixed
  set Contact pairs = a -> b, c -> d
)" + lines +
         R"(
  subsection Body one
    set Young's modulus = 210 GPa
  end
  subsection Body other
    set Young's modulus = 210 GPa
  end
  subsection Load top
    set Type = traction
    set Value = 10 MPa
    set Direction = 3, -4
  end
  subsection Load core
    set Type = force
    set Value = 2 kN
    set Direction = 0, -1
  end
  subsection Load lid
    set Type = displacement
    set Value = 0.1 mm
    set Direction = 0, 1
  end
end
)";
}

class WithSteps : public CaseDirectory {
 public:
  explicit WithSteps(const std::string& table,
                     const std::string& lines = "  set Load steps = steps.csv\n")
      : CaseDirectory(case_text(lines)) {
    write("geometry.geo", "");
    write("steps.csv", table);
  }
};

fem::Problem<2> problem_of(const CaseDirectory& directory) {
  return std::get<fem::Problem<2>>(directory.read().geometry->problem);
}

TEST(LoadSteps, MultiplyLoadsAndComponentsOfTractions) {
  const fem::Problem<2> problem =
      problem_of(WithSteps("# pressed, then moved\ntime [s], top x, core, lid\n0, 0, 0.5, 2\n\n1, "
                           "-0.25, 1, 3\n"));
  ASSERT_EQ(problem.loads.size(), 2U) << "one for each component";
  EXPECT_NEAR(problem.loads[0].traction[0], 6e6, 1e-6);
  EXPECT_NEAR(problem.loads[1].traction[1], -8e6, 1e-6);
  ASSERT_EQ(problem.steps.size(), 2U);
  EXPECT_EQ(problem.steps[0].surface_loads, (std::vector<double>{0., 1.}));
  EXPECT_EQ(problem.steps[1].surface_loads, (std::vector<double>{-0.25, 1.}));
  EXPECT_EQ(problem.steps[0].ties, std::vector<double>{0.5});
  EXPECT_EQ(problem.steps[1].supports, (std::vector<double>{1., 3.}))
      << "what stands still goes on to, whatever its factor";
}

TEST(LoadSteps, AreNoneWithoutAFile) { EXPECT_TRUE(problem_of(WithSteps("", "")).steps.empty()); }

TEST(LoadSteps, BelongToTheCaseThatNamesThem) {
  const auto inputs = WithSteps("time [s], core\n0, 1\n").read().inputs;
  EXPECT_EQ(inputs.back().filename(), "steps.csv");
}

TEST(LoadSteps, AreRefusedWhereALoadIsUnknown) {
  for (const char* const column : {"bottom", "core x", "top z", "nothing"}) {
    const std::string text = WithSteps("time [s], " + std::string(column) + "\n0, 1\n").refusal();
    EXPECT_NE(text.find(column), std::string::npos) << text;
    EXPECT_NE(text.find("'Load steps'"), std::string::npos) << text;
  }
}

TEST(LoadSteps, KnowTheirTimesInAnyUnit) {
  const fem::Problem<2> problem =
      problem_of(WithSteps("\xEF\xBB\xBFtime [ms], core\n0, 1\n2.5, 2\n"));
  ASSERT_EQ(problem.steps.size(), 2U) << "with the mark that spreadsheets write";
  EXPECT_DOUBLE_EQ(problem.steps[1].time, 2.5e-3);
}

TEST(LoadSteps, AreRefusedWhereALoadAndAComponentOfItAreGiven) {
  const std::string text = WithSteps("time [s], top x, top\n0, 1, 1\n").refusal();
  EXPECT_NE(text.find("'top x' a component of it"), std::string::npos) << text;
  EXPECT_NE(WithSteps("time [m], core\n0, 1\n").refusal().find("steps.csv, line 1"),
            std::string::npos);
}

TEST(LoadSteps, AreRefusedWithFileAndLine) {
  EXPECT_NE(WithSteps("time [s], core\n0, 1\n0, 2\n").refusal().find("steps.csv, line 3"),
            std::string::npos);
  EXPECT_NE(WithSteps("time [s], core, core\n0, 1, 1\n").refusal().find("twice"),
            std::string::npos);
  EXPECT_NE(WithSteps("").refusal().find("no load step"), std::string::npos);
}

TEST(FrictionCoefficient, IsOneForAllPairsOrOneForEach) {
  const auto coefficients = [](const std::string& value) {
    std::vector<double> result;
    for (const fem::ContactPair& pair :
         problem_of(WithSteps("", "  set Friction coefficient = " + value + "\n")).pairs)
      result.push_back(pair.friction.coefficient);
    return result;
  };
  EXPECT_EQ(coefficients("0.2"), (std::vector<double>{0.2, 0.2}));
  EXPECT_EQ(coefficients("0.2, 0"), (std::vector<double>{0.2, 0.}));
  EXPECT_NE(WithSteps("", "  set Friction coefficient = 0.1, 0.2, 0.3\n")
                .refusal()
                .find("3 numbers and 2 contact pairs"),
            std::string::npos);
}

}  // namespace
