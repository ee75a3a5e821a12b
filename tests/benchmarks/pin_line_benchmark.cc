// What a pin in space costs without finite elements: by the number of sections, to an accuracy,
// many pins, and the start of the tables. Run by hand: timings are no tests.

#include <benchmark/benchmark.h>

#include <cmath>

#include "loads/pi.h"
#include "loads/pin/cylinder_kernel.h"
#include "loads/pin/pin_line.h"
#include "loads/pin/profile_search.h"
#include "loads/pin/slab_kernel.h"

namespace {

using namespace geneva::loads;

constexpr double force = 1033.7;  // [N], of Johnson's optimum wheel

/// Johnson's optimum wheel with its pin, held at one end, tilted and crowned.
PinLine johnson() {
  PinLine pin{};
  pin.pin = {207e9, 0.3};
  pin.wheel = pin.pin;
  pin.radius = 0.00863;
  pin.relative_radius = pin.radius;
  pin.clearance.wall_half = pin.radius;
  pin.clearance.lower_end = -pin.radius - 0.00254;
  pin.clearance.upper_end = pin.radius + 0.00381;
  pin.clearance.profile = Crown{80. * 0.0254};
  pin.clearance.tilt = 0.1 * degree;
  pin.wheel_twist = 1.2e-5;
  return pin;
}

/// Argument: accuracy in 1e-5.
void one_pin(benchmark::State& state) {
  const PinLine pin = johnson();
  const double accuracy = 1e-5 * static_cast<double>(state.range(0));
  PinLineContact contact;
  for ([[maybe_unused]] auto _ : state) {
    contact = pin_line_contact(pin, force, accuracy);
    benchmark::DoNotOptimize(contact);
  }
  state.counters["sections"] = static_cast<double>(contact.sections.size());
}
BENCHMARK(one_pin)->Arg(100)->Arg(20)->Arg(5)->Arg(1)->Unit(benchmark::kMillisecond);

/// Crowns and tilts, each at 0.1 %.
void thousand_pins(benchmark::State& state) {
  PinLine pin = johnson();
  for ([[maybe_unused]] auto _ : state)
    for (int i = 0; i < 1000; ++i) {
      pin.clearance.profile = Crown{(40. + 0.1 * i) * 0.0254};
      pin.clearance.tilt = (0.001 * i - 0.5) * 0.1 * degree;
      benchmark::DoNotOptimize(pin_line_contact(pin, force, 1e-3));
    }
}
BENCHMARK(thousand_pins)->Unit(benchmark::kMillisecond);

/// Of a contact that reaches a sharp edge.
void pin_at_an_edge(benchmark::State& state) {
  PinLine pin = johnson();
  pin.clearance.profile = Cylinder{};
  pin.clearance.tilt = 0.;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(pin_line_contact(pin, force, 1e-3));
}
BENCHMARK(pin_at_an_edge)->Unit(benchmark::kMillisecond);

void start_of_tables(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(CylinderKernel(0.28));
    benchmark::DoNotOptimize(CylinderKernel(0.28, PinInside::held_core, 0.42));
    benchmark::DoNotOptimize(SlabKernel(0.28));
  }
}
BENCHMARK(start_of_tables)->Unit(benchmark::kMillisecond);

/// The crown of a pin that may lean by 0.05 deg.
void crown_search(benchmark::State& state) {
  const double tilt = 0.05 * degree;
  const ProfileDuty duty{
      johnson(), [](const double size) { return Crown{size}; }, 20., 0.02, {-tilt, tilt}, force};
  for ([[maybe_unused]] auto _ : state) {
    const ProfileSearch found = find_profile(duty);
    benchmark::DoNotOptimize(map_around(duty, found.best.size));
  }
}
BENCHMARK(crown_search)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
