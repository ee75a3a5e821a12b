#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/input/parameters.h"

namespace geneva::model {

/// A dimension that is free between bounds.
struct FreeDimension {
  SectionPath section;
  std::string name;
  double lower;  ///< in the unit
  double upper;
  std::string unit;

  /// As a case file would say it.
  [[nodiscard]] std::string text(double value) const;
};

/// What `geneva optimise` looks for.
struct OptimisationCase {
  enum class Goal { pressure, pressure_of_cycle, mass, slot_bottom };

  std::vector<FreeDimension> free;
  Goal goal;
  std::optional<double> largest_pressure;     ///< of the cycle [Pa]
  std::optional<double> largest_mass;         ///< of the wheel [kg]
  std::optional<double> least_wall;           ///< of the wheel [m]; none: a rule gives it
  std::optional<double> largest_slot_bottom;  ///< tensile stress of the wheel [Pa]
  std::optional<double> largest_root_stress;  ///< of the pin, by beam theory [Pa]
};

/// Parameters of the subsection Optimisation.
std::vector<Parameter> optimisation_parameters();

}  // namespace geneva::model
