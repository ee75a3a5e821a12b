#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"

namespace geneva::post {

/// The greatest value of a figure beside what the case allows; SI units.
struct LimitRow {
  std::string quantity;
  base::Dimension dimension;
  double value;
  double allowed;
  std::optional<double> driver_angle;  ///< of the value [rad]
  std::string meaning;                 ///< of the limit or its place, in words; may be empty

  /// Allowed over value: 1 at the limit; infinite of 0.
  [[nodiscard]] double factor() const;
};

/// The least factor; none without rows.
std::optional<double> least_factor(const std::vector<LimitRow>& rows);

/// What JSON documents say of limits, with the keys of the section `safety` of a run.
nlohmann::json limits_section(const std::vector<LimitRow>& rows);

/// Lines for the terminal; empty without rows.
std::string limit_lines(const std::vector<LimitRow>& rows, base::UnitSystem units);

}  // namespace geneva::post
