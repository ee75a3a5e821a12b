#pragma once

#include <nlohmann/json_fwd.hpp>

#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::post {

/// The machine-readable summary, always in SI units; doc/results.md lists the keys.
template <int dim>
nlohmann::json summary(const fem::Solution<dim>& solution, const Results<dim>& results,
                       const RunReport& report);

}  // namespace geneva::post
