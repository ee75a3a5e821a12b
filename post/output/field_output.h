#pragma once

#include <filesystem>

#include "base/units.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// Writes solution.pvd, solution.pvtu, solution.N.vtu and results.h5, results.xdmf into a
/// directory: displacement, stress tensor, out-of-plane stress, von Mises, principal stresses,
/// maximum shear, body; in the plane McEwen's stress near the contact and the difference from it.
/// Every rank takes part.
/// @throws base::InputError if a file cannot be written
template <int dim>
void write_fields(const fem::Solution<dim>& solution, const Results<dim>& results,
                  base::UnitSystem units, const std::filesystem::path& directory);

}  // namespace geneva::post
