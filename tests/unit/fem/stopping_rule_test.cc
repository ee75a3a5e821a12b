#include "fem/adaptivity/stopping_rule.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <vector>

#include "fem/adaptivity/resource_limits.h"

namespace geneva::fem {
namespace {

LevelRecord level(const unsigned int dofs, const double peak_pressure, const double seconds) {
  LevelRecord record{};
  record.dofs = dofs;
  record.peak_pressure = peak_pressure;
  record.seconds = seconds;
  record.refined = Refined::zone;
  record.halvings = 1;
  record.active_nodes = dofs / 100;
  record.nodes_across = dofs / 100;
  return record;
}

Outcome outcome_of(const std::vector<LevelRecord>& history, const Standing& standing) {
  const auto stop = why_to_stop(history, standing, Settings());
  EXPECT_TRUE(stop.has_value());
  return stop ? stop->outcome : Outcome::converged;
}

const std::vector<LevelRecord> settling{level(1000, 1.05e6, 1.), level(2000, 1.01e6, 2.),
                                        level(4000, 1.e6, 4.)};
const std::vector<LevelRecord> growing{level(1000, 1.0e6, 1.), level(2000, 1.2e6, 2.),
                                       level(3000, 1.5e6, 3.), level(4000, 1.9e6, 4.),
                                       level(5000, 2.4e6, 5.), level(6000, 3.e6, 6.)};

TEST(StoppingRule, GoesOnUntilTheAccuracyIsReached) {
  EXPECT_FALSE(why_to_stop(settling, {0.006, {}, false, 2}, Settings()).has_value());
  EXPECT_EQ(outcome_of(settling, {0.005, {}, false, 2}), Outcome::converged);
}

TEST(StoppingRule, SaysThatTheRestConvergedBesideASharpEdge) {
  const EdgePressure sharp{false, 0.21, 3e6};
  EXPECT_EQ(outcome_of(settling, {0.005, sharp, true, 2}), Outcome::unbounded_edge);
  EXPECT_EQ(why_to_stop(settling, {0.005, sharp, true, 2}, Settings())->growth, 0.21);
  EXPECT_FALSE(why_to_stop(settling, {0.006, sharp, true, 2}, Settings()).has_value());
}

TEST(StoppingRule, CallsAPressureUnboundedOnlyAtACorner) {
  EXPECT_EQ(outcome_of(growing, {1., {}, true, 5}), Outcome::unbounded_pressure);
  EXPECT_FALSE(why_to_stop(growing, {1., {}, false, 5}, Settings()).has_value());
}

TEST(StoppingRule, SeesThatFinerMeshesDoNotHelp) {
  std::vector<LevelRecord> still;
  for (const unsigned int dofs : {1000U, 2000U, 3000U, 4000U, 5000U}) {
    still.push_back(level(dofs, 1e6, 1.));
    still.back().active_nodes = still.back().nodes_across = 2;
  }
  EXPECT_EQ(outcome_of(still, {1., {}, false, 4}), Outcome::no_progress);
}

TEST(StoppingRule, KeepsTheLimitOfRefinements) {
  Settings settings;
  settings.max_levels = 3;
  EXPECT_FALSE(why_to_stop(settling, {0.1, {}, false, 2}, settings).has_value());
  const auto stop = why_to_stop(settling, {0.1, {}, false, 3}, settings);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->outcome, Outcome::refinement_limit);
  EXPECT_EQ(stop->limit, 3.);
}

TEST(ResourceLimits, ForeseeTheUnknownsOfTheNextMesh) {
  Settings settings;
  settings.max_dofs = 7999;
  const ResourceLimits limits(MPI_COMM_WORLD, settings);
  EXPECT_FALSE(limits.exceeded_by_next(1.9, settling, 0.).has_value());
  const auto stop = limits.exceeded_by_next(2., settling, 0.);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->outcome, Outcome::dof_limit);
  EXPECT_EQ(stop->needed, 8000.);
  EXPECT_EQ(stop->limit, 7999.);
  EXPECT_FALSE(limits.exceeded_by(7999.).has_value());
  EXPECT_TRUE(limits.exceeded_by(8000.).has_value());
}

/// The last mesh took 4 s - 2 s; one that is three times as large takes 6 s more.
TEST(ResourceLimits, ForeseeTheEndOfTheNextMesh) {
  Settings settings;
  settings.max_seconds = 10.;
  const ResourceLimits limits(MPI_COMM_WORLD, settings);
  EXPECT_FALSE(limits.exceeded_by_next(3., settling, 0.).has_value());
  const auto stop = limits.exceeded_by_next(3.1, settling, 0.);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->outcome, Outcome::time_limit);
  EXPECT_NEAR(stop->needed, 10.2, 1e-12);
  EXPECT_FALSE(limits.exceeded_by_next(3.1, settling, 2.).has_value())
      << "what an earlier run took does not count";
}

TEST(ResourceLimits, OfMemoryCountOnlyWhatMeshesTake) {
  Settings settings;
  settings.max_memory = 1e6;  // less than the process has already
  const auto stop = ResourceLimits(MPI_COMM_WORLD, settings).exceeded_by_next(1., settling, 0.);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->outcome, Outcome::memory_limit);
  EXPECT_GT(stop->needed, 1e6);
}

/// Memory [byte] that goes back to the system, as that of malloc() may not.
void take_and_give_back(const std::size_t size) {
  void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  ::munmap(memory, size);
}

TEST(ResourceLimits, WhatTheProcessTookBeforeAndGaveBackDoesNotCount) {
  constexpr std::size_t much = 300'000'000;
  take_and_give_back(much);
  const double before = peak_memory(MPI_COMM_SELF);
  Settings settings;
  settings.max_memory = 1.;
  const ResourceLimits limits(MPI_COMM_SELF, settings);
  const double idle = limits.exceeded_by_next(1., settling, 0.)->needed;
  EXPECT_LT(idle, before - 0.8 * much);
  take_and_give_back(much);
  const double next = limits.exceeded_by_next(2., settling, 0.)->needed;
  EXPECT_NEAR(next - idle, 2. * much, 0.1 * much) << "a mesh twice as large takes twice as much";
}

}  // namespace
}  // namespace geneva::fem
