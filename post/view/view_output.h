#pragma once

#include <filesystem>

#include "post/results.h"
#include "post/units.h"

namespace geneva::post {

/// Writes view.json: what can be seen of the solution, as triangles with displacements and stresses
/// in output units; in space also cuts across the pin where the pressure is greatest and along it,
/// and the contact pressure on the source surface. doc/results.md describes it. Every rank takes
/// part.
/// @throws std::runtime_error on rank 0 if the file cannot be written
template <int dim>
void write_view(const fem::Solution<dim>& solution, const Results<dim>& results, UnitSystem units,
                const std::filesystem::path& directory);

}  // namespace geneva::post
