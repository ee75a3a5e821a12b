#pragma once

#include <vector>

#include "post/analysis/check.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// The checks of a run: balance of forces and moments, the torque that the shaft takes, the
/// complementarity of pressure and gap, penetration, and the error estimate.
template <int dim>
std::vector<Check> checks(const fem::Solution<dim>& solution, const Results<dim>& results,
                          const RunReport& report);

}  // namespace geneva::post
