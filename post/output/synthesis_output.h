#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "base/units.h"
#include "loads/synthesis/crank_rocker.h"
#include "loads/synthesis/path_synthesis.h"
#include "loads/synthesis/quick_return.h"

namespace geneva::post {

/// A quick-return mechanism and its positions over a turn of the crank, SI units.
struct QuickReturnReport {
  loads::QuickReturn mechanism;
  double maximum_wheel_speed;  ///< [rad/s], as given
  double engagement;           ///< crank angle while the Geneva's pin would be in the slot [rad]
  loads::QuickReturnExtremes extremes;
  std::vector<loads::QuickReturnPosition> positions;
};

/// A crank-rocker at one crank angle.
struct RockerPosition {
  double crank_angle;         ///< phi_2 [rad]
  double coupler_angle;       ///< phi_3 [rad]
  double rocker_angle;        ///< phi_4 [rad]
  double speed_ratio;         ///< omega_4/omega_2
  double transmission_angle;  ///< between coupler and rocker [rad], at most pi/2
};

/// A crank-rocker and its positions over a turn of the crank, SI units.
struct CrankRockerReport {
  loads::CrankRocker mechanism;
  RockerPosition farthest;  ///< of the rocker from the crank's pivot
  RockerPosition nearest;
  bool crank_turns_fully;
  double swing;       ///< between the two positions [rad]
  double time_ratio;  ///< of the rocker's ways forward and back
  std::vector<RockerPosition> positions;
};

/// What was asked of a path generator, and all that was found.
struct PathReport {
  loads::PathTask task;
  loads::PathSynthesis synthesis;
};

/// The linkages that `geneva synthesize` found for one case.
struct SynthesisReport {
  std::string case_name;
  std::string title;
  std::string geneva_version;
  std::variant<QuickReturnReport, CrankRockerReport, PathReport> result;
};

/// What synthesis.json says, SI units throughout.
nlohmann::json synthesis_summary(const SynthesisReport& report);

/// What synthesis.csv says, the units in the headings: positions over a turn of the crank, or a row
/// for each path generator.
std::string synthesis_csv(const SynthesisReport& report, base::UnitSystem units);

/// Dimensions and extreme positions, or the first twelve path generators.
std::string synthesis_table(const SynthesisReport& report, base::UnitSystem units);

}  // namespace geneva::post
