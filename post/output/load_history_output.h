#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "post/output/limit_rows.h"

namespace geneva::post {

/// A contact pair at one load step, SI units; z is 0 in the plane.
struct ContactAtStep {
  std::string source;
  std::string target;
  std::array<double, 3> force;           ///< of the pressure on the source [N]
  std::array<double, 3> friction_force;  ///< on the source [N]
  double peak_pressure;                  ///< [Pa], >= 0
  double half_width;             ///< [m], >= 0; in 3-D of the middle section, or the semi-axis
                                 ///< across z
  std::optional<double> change;  ///< of that from the mesh before to the last one, relative; none
                                 ///< without pressure on both
  std::size_t sticking;          ///< nodes
  std::size_t slipping;
  double dissipated;  ///< by friction since the first step [J], >= 0
};

/// Maximum stresses of a body at one load step, with those of the contact's own field [Pa].
struct StressAtStep {
  std::string body;
  double von_mises;
  double first_principal;
};

/// What was found at one load step.
struct LoadStepPoint {
  double time;  ///< [s]
  std::vector<ContactAtStep> contacts;
  std::vector<StressAtStep> stresses;
  double work;    ///< of the loads since the first step [J]
  double stored;  ///< elastic energy [J]
};

/// A geometry case over its load steps.
struct LoadHistoryReport {
  base::CaseHeader about;
  std::string geneva_version;
  double accuracy;                   ///< wanted of the last step, relative
  std::optional<double> error;       ///< of its peak pressure, estimated, relative; none: not known
  bool is_bounded = true;            ///< whether the pressure is, see post::is_bounded()
  std::vector<LoadStepPoint> steps;  ///< the first one is step 1
  std::vector<LimitRow> limits;      ///< at the step where each is nearest
  std::vector<std::string> notices;
  double seconds;
  unsigned int ranks;
};

/// Where the contact pressure is greatest.
struct GreatestAtStep {
  std::size_t step;     ///< index
  std::size_t contact;  ///< index
};

/// Of those that differ by round-off alone the last one; none if nothing is ever pressed.
std::optional<GreatestAtStep> greatest_pressure(const LoadHistoryReport& report);

/// What load_steps.json says, SI units throughout.
nlohmann::json load_history_summary(const LoadHistoryReport& report);

/// What load_steps.csv says: a line for each step and contact pair, the units in the headings.
std::string load_history_csv(const LoadHistoryReport& report, base::UnitSystem units);

/// The steps and what is greatest, as lines.
std::string load_history_table(const LoadHistoryReport& report, base::UnitSystem units);

}  // namespace geneva::post
