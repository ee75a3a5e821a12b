#pragma once

#include <string>

#include "post/summary.h"

namespace geneva::post {

/// The table that ends a run: this program, closed form, published value, difference.
template <int dim>
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, UnitSystem units);

}  // namespace geneva::post
