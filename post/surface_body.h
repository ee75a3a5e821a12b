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

}  // namespace geneva::post
