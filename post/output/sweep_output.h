#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"

namespace geneva::post {

/// A figure of one point of a sweep; SI units.
struct SweepFigure {
  std::string quantity;
  base::Dimension dimension;
  std::optional<double> value;  ///< none where it is not bounded
  std::optional<double> error;  ///< estimated, relative; none where it is exact or unknown
  std::optional<double> limit;  ///< that the case allows
};

/// A combination of the values that are varied, and what was found.
struct SweepPoint {
  std::vector<std::string> values;  ///< of the parameters, as the case file would say them
  std::string directory;            ///< of its case and results, within the sweep's; may be empty
  int exit_code;
  std::string message;  ///< why there are no figures, or what they lack
  std::vector<SweepFigure> figures;
};

/// The figures of a case over some of its parameters.
struct SweepReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string command;                  ///< "run", "estimate", "kinematics" or "design"
  std::vector<std::string> parameters;  ///< "Mechanism/Pin diameter"
  std::vector<std::string> notices;     ///< on the cases
  std::vector<SweepPoint> points;
};

/// Names of the figures that any point has, in the order in which they appear.
std::vector<std::string> sweep_quantities(const SweepReport& report);

/// A number in front of a unit, as a case file says it.
struct SweepValue {
  double number;
  std::string unit;
};

/// The numbers of a parameter over the points; nothing if one is no number or the units differ.
std::optional<std::vector<SweepValue>> sweep_numbers(const SweepReport& report,
                                                     std::size_t parameter);

/// What sweep.json says, SI units but for the parameters' own.
nlohmann::json sweep_summary(const SweepReport& report);

/// What sweep.csv says: a row for each point, the units in the headings.
std::string sweep_csv(const SweepReport& report, base::UnitSystem units);

/// Table of the points: the parameters, the peak pressure, the least safety factor, and the figures
/// that change most.
std::string sweep_table(const SweepReport& report, base::UnitSystem units);

}  // namespace geneva::post
