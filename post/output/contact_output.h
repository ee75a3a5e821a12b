#pragma once

#include <filesystem>
#include <optional>

#include "base/units.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// Writes contact.vtu and contact.csv: place (in the plane with the arc length), contact pressure,
/// gap, status and Hertz's pressure at the source nodes; in the plane also depth.csv with the
/// stress below the contact beside McEwen's, in 3-D sections.csv with line load, peak pressure,
/// half-width and maximum shear along z; in both the line load of line contacts along the pin, if
/// they are given. One rank calls it.
/// @param line none without a pin, or where line contacts know no answer
/// @throws base::InputError if a file cannot be written
template <int dim>
void write_contact(const fem::Solution<dim>& solution, const Results<dim>& results,
                   const std::optional<PinLineReport>& line, base::UnitSystem units,
                   const std::filesystem::path& directory);

}  // namespace geneva::post
