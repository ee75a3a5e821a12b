#pragma once

#include "fem/contact/surface.h"

namespace geneva::fem {

/// Whether the surface has a part that bulges more than the next one, without a corner between
/// them, as a flat with a rounded edge.
template <int dim>
bool has_rounded_edge(const Surface<dim>& surface);

}  // namespace geneva::fem
