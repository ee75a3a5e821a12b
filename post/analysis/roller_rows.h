#pragma once

#include <vector>

#include "post/analysis/comparison_row.h"
#include "post/analysis/figures.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// The bore of a roller: its mean pressure F/(d_b t), and, where stud and bore are modelled, the
/// peak pressure and the angle over which they touch, beside Hertz's where that applies. Nothing of
/// a pin that is fixed to its carrier.
std::vector<ComparisonRow> roller_rows(const fem::Solution<2>& solution, const Results<2>& results,
                                       const RunReport& report);
/// The mean pressure alone.
std::vector<ComparisonRow> roller_rows(const fem::Solution<3>& solution, const Results<3>& results,
                                       const RunReport& report);

}  // namespace geneva::post
