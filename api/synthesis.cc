#include "api/synthesis.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>

#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "loads/pi.h"
#include "model/naming.h"

namespace geneva {

namespace {

using loads::pi;

constexpr int steps = 360;  // of a turn of the crank

post::QuickReturnReport make_quick_return(const loads::QuickReturnInput& input) {
  const loads::QuickReturn mechanism = loads::quick_return(input);
  post::QuickReturnReport report{
      mechanism, input.maximum_wheel_speed, 0., loads::extreme_positions(mechanism), {}};
  report.engagement =
      report.extremes.rocker_last.crank_angle - report.extremes.rocker_first.crank_angle;
  for (int step = 0; step <= steps; ++step)
    report.positions.push_back(loads::position(mechanism, -pi + 2. * pi * step / steps));
  return report;
}

post::RockerPosition rocker_position(const loads::CrankRocker& mechanism, const double angle) {
  const loads::FourBarMotion motion = loads::motion(mechanism.linkage, mechanism.assembly, angle);
  const double between = motion.coupler_angle[0] - motion.rocker_angle[0];
  return {angle, motion.coupler_angle[0], motion.rocker_angle[0], motion.rocker_angle[1],
          std::asin(std::abs(std::sin(between)))};
}

post::CrankRockerReport make_crank_rocker(const loads::CrankRockerInput& input) {
  const loads::CrankRocker mechanism = loads::crank_rocker(input);
  post::CrankRockerReport report{mechanism,
                                 rocker_position(mechanism, mechanism.far_crank),
                                 rocker_position(mechanism, mechanism.near_crank),
                                 loads::crank_turns_fully(mechanism.linkage),
                                 0.,
                                 0.,
                                 {}};
  const double forward = report.nearest.crank_angle - report.farthest.crank_angle;
  report.swing = report.nearest.rocker_angle - report.farthest.rocker_angle;
  report.time_ratio = forward / (2. * pi - forward);
  for (int step = 0; step <= steps; ++step)
    report.positions.push_back(rocker_position(mechanism, 2. * pi * step / steps));
  return report;
}

/// What the loads room still refuses are the points.
post::PathReport make_path(const model::PathCase& given) {
  try {
    return {given.task, loads::synthesise_path(given.task)};
  } catch (const std::invalid_argument& error) {
    throw base::InputError(given.file.string() + ": " + error.what());
  }
}

struct Maker {
  using Result = decltype(post::SynthesisReport::result);
  Result operator()(const loads::QuickReturnInput& input) const { return make_quick_return(input); }
  Result operator()(const loads::CrankRockerInput& input) const { return make_crank_rocker(input); }
  Result operator()(const model::PathCase& input) const { return make_path(input); }
};

/// Why there is no linkage, and what to try; empty if there is one.
std::string shortfall(const post::SynthesisReport& report, const base::UnitSystem units) {
  const auto* path = std::get_if<post::PathReport>(&report.result);
  if (path == nullptr || !path->synthesis.solutions.empty()) return "";
  const loads::PathSynthesis& synthesis = path->synthesis;
  const auto length = base::output_unit(units, base::Dimension::length);
  const std::string least =
      std::isfinite(synthesis.minimum_residual)
          ? fmt::format("the minimum residual of the equations is {:.3g} {}",
                        synthesis.minimum_residual * length.factor, length.name)
          : "none came near a linkage";
  return fmt::format(
      "not converged: no linkage through all {} points was found in {} start{}, {}; that does not "
      "prove that there is none: try more 'Starts', another 'Seed', other points, or fewer of them",
      path->task.points.size(), synthesis.starts, synthesis.starts == 1 ? "" : "s", least);
}

post::SynthesisReport synthesis_report(const Case& given) {
  if (!given.synthesis)
    model::refuse_model(given, "there is no linkage to find", "geneva synthesize", "synthesis");
  return {name_of(given), given.title, version, std::visit(Maker{}, *given.synthesis)};
}

}  // namespace

Synthesis synthesize(const Case& given) {
  return model::naming(given, [&] {
    post::SynthesisReport report = synthesis_report(given);
    std::string why = shortfall(report, given.units);
    return Synthesis{given, std::move(report), std::move(why)};
  });
}

std::string table(const Synthesis& synthesis) {
  return post::synthesis_table(synthesis.report, synthesis.given.units);
}

Written write(const Synthesis& synthesis, const std::filesystem::path& directory) {
  const auto& [given, report, shortfall] = synthesis;
  return api::write_results(directory, given, "synthesis",
                            {{"synthesis.json", post::synthesis_summary(report).dump(2) + "\n"},
                             {"synthesis.csv", post::synthesis_csv(report, given.units)}});
}

}  // namespace geneva
