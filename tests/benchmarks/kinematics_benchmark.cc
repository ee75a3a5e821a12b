#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "loads/motion/external_geneva.h"
#include "loads/motion/four_bar_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/kinematics.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"

/// Kinematics, pin force and pressure of a full revolution at 100 000 angles: to stay below 0.1 s.
namespace {

using namespace geneva::loads;

constexpr int steps = 100000;

void revolution(benchmark::State& state, const Mechanism& mechanism) {
  const auto pins = engagements(mechanism, {0.});
  const DrivenMechanism driven(mechanism, pins, constant_speed(mechanism, pins, 60.));
  const WheelTrain train{1e-3, {1e-3, 0.1}, 0., 0.1, 0.01};
  const PinContact contact{1e11, 0.01, 0.01};
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(kinematics_rows(driven, train, contact, steps));
}

void law_on_the_cross(benchmark::State& state) {
  const Mechanism mechanism = external_geneva(6, 0.1);
  const auto pins = engagements(mechanism, {0.});
  const DrivenMechanism driven(
      mechanism, pins,
      law_on_cross(mechanism, PlaneGeneva::external, 0.1, pins, MotionLaw::cycloidal, 0.1));
  const WheelTrain train{1e-3, {1e-3, 0.1}};
  const PinContact contact{1e11, 0.01, 0.01};
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(kinematics_rows(driven, train, contact, steps));
}

BENCHMARK_CAPTURE(revolution, external, external_geneva(6, 0.1))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(revolution, internal, internal_geneva(6, 0.1))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(revolution, spherical, spherical_geneva(8, 1.5, 0.1))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(revolution, long_dwell,
                  long_dwell_geneva(6, 0.05, 0.1, SprocketLine::across_line_of_centres))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(revolution, four_bar,
                  four_bar_geneva(6, {{0., 0.}, {0.1, 0.}, 0.04, 0.12, 0.12, 0.12, 1.57},
                                  Assembly::open, {2.6, std::nullopt})
                      .mechanism)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(law_on_the_cross)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
