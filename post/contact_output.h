#pragma once

#include <filesystem>

#include "post/results.h"
#include "post/units.h"

namespace geneva::post {

/// Writes contact.vtu and contact.csv: arc length, contact pressure, gap, status and Hertz's
/// pressure at the source nodes. One rank calls it.
/// @throws std::runtime_error if a file cannot be written
void write_contact(const fem::Solution<2>& solution, const Results& results, UnitSystem units,
                   const std::filesystem::path& directory);

}  // namespace geneva::post
