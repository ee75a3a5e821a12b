#pragma once

#include <string>
#include <vector>

#include "base/units.h"
#include "post/analysis/comparison_row.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// The figures of a run, the contact force first.
template <int dim>
std::vector<ComparisonRow> comparison(const fem::Solution<dim>& solution,
                                      const Results<dim>& results, const RunReport& report);

/// The table that ends a run: this program with its error, closed form, published value,
/// difference, and below it the estimated error, the balance of forces and the safety factors.
template <int dim>
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, base::UnitSystem units);

}  // namespace geneva::post
