#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "post/output/limit_rows.h"

namespace geneva::post {

/// A dimension that was free, as the case file would say it.
struct OptimumDimension {
  std::string name;    ///< "Wheel diameter"
  std::string before;  ///< as the case has it; empty if the case leaves it to a rule
  std::string after;
  std::string bound;  ///< "lower" or "upper" where it stands on one, else empty
  bool has_effect;    ///< on the goal or a limit
  std::string edge;   ///< why nothing can be worked out beside `after`; empty: it can
};

/// A figure before and after; SI units.
struct OptimumFigure {
  std::string quantity;
  base::Dimension dimension;
  std::optional<double> before;  ///< none if the case as it stands cannot be drawn
  double after;
  std::optional<double> limit;      ///< of the case
  bool binds;                       ///< the limit
  std::optional<double> confirmed;  ///< of `after`, by finite elements
  std::optional<double> error;      ///< of that, relative
  std::string place;                ///< of `after`, where it has one

  /// Whether finite elements find the limit of a greatest value exceeded, beyond their error.
  [[nodiscard]] bool is_exceeded() const;
};

/// The best dimensions that were found.
struct OptimumReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string goal;   ///< what is least, the name of a figure
  std::string basis;  ///< of the pressures: "Hertz, an even load" or "line contacts along the pin"
  std::vector<OptimumDimension> dimensions;
  std::vector<OptimumFigure> figures;
  std::vector<LimitRow> limits;  ///< of the best case over the cycle, by case and materials
  int trials;                    ///< how many candidates were worked out
};

/// What optimum.json says, SI units but for the dimensions' own.
nlohmann::json optimum_summary(const OptimumReport& report);

/// What optimum.csv says: the figures before and after, the units in a column.
std::string optimum_csv(const OptimumReport& report, base::UnitSystem units);

/// Dimensions, figures and what binds, as lines.
std::string optimum_table(const OptimumReport& report, base::UnitSystem units);

}  // namespace geneva::post
