#pragma once

#include <string>

#include "api/surfaces.h"

namespace geneva::api {

/// A page that shows the surfaces of a geometry file from two opposite sides, in the plane the
/// boundary, each with its number and colour, over a table of names, shapes, sizes and places. It
/// needs nothing else.
std::string surface_page(const SurfaceList& list);

}  // namespace geneva::api
