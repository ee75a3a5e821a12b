#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/units.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// What view.json holds: visualisation data of the solution, triangles with displacements and
/// stresses in output units; in 3-D also cuts across the pin where the pressure is greatest and
/// along it, and the contact pressure on the source surface. doc/results.md describes it. Every
/// rank takes part.
/// @return on rank 0; null on the others, and if nothing is in contact
template <int dim>
nlohmann::json view_document(const fem::Solution<dim>& solution, const Results<dim>& results,
                             base::UnitSystem units);

}  // namespace geneva::post
