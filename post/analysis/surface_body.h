#pragma once

#include <string>

#include "fem/solution.h"
#include "loads/hertz.h"

namespace geneva::post {

/// The body that a named surface bounds, an index into Problem::bodies.
template <int dim>
unsigned int body_of(const fem::Solution<dim>& solution, const std::string& surface);

/// Its material.
template <int dim>
loads::Elastic material_of(const fem::Solution<dim>& solution, const std::string& surface);

/// 1/R of one side of a contact: positive where the body bulges, 0 for a flat [1/m].
/// @param circle index into MeshData::circles; -1: straight
template <int dim>
double curvature(const fem::Solution<dim>& solution, int circle, bool is_convex);

}  // namespace geneva::post
