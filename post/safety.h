#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/results.h"
#include "post/run_report.h"

namespace geneva::post {

/// A figure of a run beside what the case allows; SI units.
struct SafetyRow {
  std::string quantity;
  Dimension dimension;
  std::optional<double>
      computed;  ///< none where an edge pressure is not bounded, nor anything else
  double allowed;

  /// Allowed over computed: 1 at the limit.
  [[nodiscard]] std::optional<double> factor() const {
    return computed ? std::optional(allowed / *computed) : std::nullopt;
  }
};

/// A row for everything that the case allows: contact pressure, pressure times slip speed, von
/// Mises stress of the bodies against their yield strengths.
template <int dim>
std::vector<SafetyRow> safety(const fem::Solution<dim>& solution, const Results<dim>& results,
                              const RunReport& report);

/// Lines for the terminal; empty without rows.
std::string safety_lines(const std::vector<SafetyRow>& rows, UnitSystem units);

}  // namespace geneva::post
