#include "model/stop_message.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "model/problem_message.h"

namespace geneva::model {
namespace {

using fem::Outcome;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StopMessage, IsEmptyWhereAllWasReached) { EXPECT_EQ(message_of({Outcome::converged}), ""); }

TEST(StopMessage, OfEveryLimitNamesItsParameterAndBothFigures) {
  const std::string unknowns = message_of({Outcome::dof_limit, 5432., 2000.});
  EXPECT_TRUE(contains(unknowns, "5432") && contains(unknowns, "2000")) << unknowns;
  EXPECT_TRUE(contains(unknowns, "'Maximum unknowns'")) << unknowns;
  const std::string coarse = message_of({Outcome::coarse_dof_limit, 123456., 2000.});
  EXPECT_TRUE(contains(coarse, "123456") && contains(coarse, "'Maximum unknowns'")) << coarse;
  const std::string memory = message_of({Outcome::memory_limit, 2.5e9, 1e9});
  EXPECT_TRUE(contains(memory, "2500 MB") && contains(memory, "1000 MB")) << memory;
  EXPECT_TRUE(contains(memory, "'Maximum memory'")) << memory;
  const std::string time = message_of({Outcome::time_limit, 75., 60.});
  EXPECT_TRUE(contains(time, "75 s") && contains(time, "60 s")) << time;
  EXPECT_TRUE(contains(time, "'Maximum time'")) << time;
  const std::string levels = message_of({Outcome::refinement_limit, 0., 6.});
  EXPECT_TRUE(contains(levels, "limit of 6") && contains(levels, "'Maximum refinement levels'"))
      << levels;
  const std::string steps = message_of({Outcome::active_set_limit, 0., 50., 777});
  EXPECT_TRUE(contains(steps, "50 steps") && contains(steps, "777 unknowns")) << steps;
  EXPECT_TRUE(contains(steps, "'Maximum active-set steps'")) << steps;
}

TEST(ProblemMessage, BeginsWithTheParameterThatIsWrong) {
  const auto text = [](const fem::ProblemPart part) {
    return message_of(fem::ProblemError(part, "no"));
  };
  EXPECT_EQ(text(fem::ProblemPart::bodies), "'Bodies': no");
  EXPECT_EQ(text(fem::ProblemPart::supports), "'Supports': no");
  EXPECT_EQ(text(fem::ProblemPart::loads), "'Loads': no");
  EXPECT_EQ(text(fem::ProblemPart::pairs), "'Contact pairs': no");
}

TEST(StopMessage, OfTheLinearSolverSaysHowFarItCame) {
  const std::string text = message_of({Outcome::linear_solver, 300., 0., 777, 1.5e-4});
  EXPECT_TRUE(contains(text, "1.50e-04 after 300 iterations")) << text;
}

TEST(StopMessage, OfAnUnboundedPressureAndEdgeSaysThatItIsSharp) {
  EXPECT_TRUE(contains(message_of({Outcome::unbounded_pressure}), "sharp edge"));
  EXPECT_TRUE(contains(message_of({Outcome::unbounded_edge, 0., 0., 0, 0., 0.21}), "power 0.21"));
}

TEST(StopMessage, DiffersFromOutcomeToOutcome) {
  std::set<std::string> texts;
  constexpr int last = static_cast<int>(Outcome::linear_solver);
  for (int i = 0; i <= last; ++i) texts.insert(message_of({static_cast<Outcome>(i)}));
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(last + 1));
}

}  // namespace
}  // namespace geneva::model
