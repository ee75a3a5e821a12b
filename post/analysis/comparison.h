#pragma once

#include <string>
#include <vector>

#include "base/units.h"
#include "post/analysis/comparison_row.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// The figures of a run: of the contact, its force first, then of the bodies.
template <int dim>
std::vector<ComparisonRow> comparison(const fem::Solution<dim>& solution,
                                      const Results<dim>& results, const RunReport& report);

/// What the accuracy of the run is that of: "peak contact pressure", "pressure in the middle" where
/// an edge pressure has no bound, or without contact "maximum stress".
template <int dim>
std::string refined_figure(const fem::Solution<dim>& solution);

/// The table that ends a run: this program with its error, closed form, published value,
/// difference, and below it the estimated error, the balance of forces and the safety factors.
template <int dim>
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, base::UnitSystem units);

}  // namespace geneva::post
