#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/units.h"

namespace geneva::post {

/// The von Mises stress of an instant in the plane, in the frame of the engaged slot; SI units.
struct InstantField {
  const std::vector<std::array<double, 3>>& places;    ///< of the nodes [m]
  const std::vector<double>& von_mises;                ///< of the nodes [Pa]
  const std::vector<std::vector<std::size_t>>& cells;  ///< four nodes of each
};

/// What cycle_view.json says, for the report.
nlohmann::json cycle_view(const std::vector<InstantField>& instants, base::UnitSystem units);

}  // namespace geneva::post
