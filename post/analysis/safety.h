#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// Maximum value of a mechanism's cycle by the closed forms.
struct CycleValue {
  double value;
  double driver_angle;  ///< [rad]
};

/// A figure of a run beside what the case allows; SI units.
struct SafetyRow {
  std::string quantity;
  base::Dimension dimension;
  std::optional<double>
      computed;  ///< of the analysis; none where an edge pressure is not bounded, nor anything else
  double allowed;
  std::optional<double> analysed_angle;  ///< of the driver [rad]; none without a mechanism
  std::optional<CycleValue> cycle;       ///< none where only the analysis knows the figure
  std::string meaning;                   ///< of the limit, as a sentence; may be empty

  /// Allowed over computed: 1 at the limit.
  [[nodiscard]] std::optional<double> computed_factor() const;
  /// Allowed over the maximum value, computed or of the cycle; none where the computed one is not
  /// bounded.
  [[nodiscard]] std::optional<double> factor() const;
  /// Driver angle [rad] of that factor.
  [[nodiscard]] std::optional<double> driver_angle() const;

 private:
  [[nodiscard]] bool is_worse_elsewhere() const;
};

/// A row for everything that the case allows: contact pressure and pressure times slip speed, over
/// the cycle and as analysed; von Mises stress of the bodies, in the plane also at the pin's root,
/// against their yield strengths. A roller does not slide on the wall: its row is the mean pressure
/// in its bore times the speed there.
template <int dim>
std::vector<SafetyRow> safety(const fem::Solution<dim>& solution, const Results<dim>& results,
                              const RunReport& report);

/// Lines for the terminal; empty without rows.
std::string safety_lines(const std::vector<SafetyRow>& rows, base::UnitSystem units);

}  // namespace geneva::post
