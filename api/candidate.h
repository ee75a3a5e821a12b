#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/case.h"
#include "base/units.h"
#include "loads/wheel/least_wall.h"

namespace geneva::api {

/// What is known of a candidate for the best dimensions; SI units.
struct Candidate {
  double pressure;
  double pressure_of_cycle;
  std::optional<double> mass;                  ///< of wheels that are drawn
  std::optional<loads::LeastWall> least_wall;  ///< of wheels that are drawn
  std::optional<double> least_wall_rule;       ///< what it must be where the case says nothing [m]
  std::optional<double> root_stress;           ///< of pins with a root
  std::optional<double> slot_bottom;           ///< where it is wanted
};

/// What the pressures of candidates are by.
enum class PressureBasis {
  even_load,     ///< Hertz
  line_contacts  ///< along a pin in 3-D
};

/// Line contacts where they know a peak of the case as it is, else the even load.
PressureBasis pressure_basis(const Case& given);

/// By closed forms; the slot's bottom is left open.
/// @throws base::InputError if there is no such mechanism, or line contacts know no peak
Candidate candidate_of(const Case& given, PressureBasis basis);

using OptimisationGoal = model::OptimisationCase::Goal;

/// As the case file and the tables call it.
const char* name_of(OptimisationGoal goal);

/// Nothing where the candidate has none.
std::optional<double> value_of(const Candidate& candidate, OptimisationGoal goal);

/// A figure of a candidate and its limit, if there is one.
struct LimitedFigure {
  enum class Bound { greatest, least };

  const char* name;
  base::Dimension dimension;
  std::optional<double> value;
  std::optional<double> limit;
  Bound bound;
  std::string place;  ///< of the value, where it has one

  /// Relative: 0 at the limit, positive beyond it, 1 where the figure is not known.
  [[nodiscard]] double excess() const;
};

/// Figures that may have a limit, in the order of the tables.
std::vector<LimitedFigure> limited_figures(const model::OptimisationCase& wanted,
                                           const Candidate& candidate);

}  // namespace geneva::api
