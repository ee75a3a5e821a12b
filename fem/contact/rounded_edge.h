#pragma once

#include "fem/contact/surface.h"

namespace geneva::fem {

/// Whether the surface passes over smoothly into a part that bulges more, as a flat does into a
/// rounded edge.
template <int dim>
bool has_rounded_edge(const Surface<dim>& surface);

}  // namespace geneva::fem
