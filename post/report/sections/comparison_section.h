#pragma once

#include <vector>

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// Runs side by side, in the units of the first: the rows of their closing tables, their curves
/// laid over each other, their pictures.
/// @param all two or more
/// @throws base::InputError if one of them holds no run
ReportPart comparison_part(const std::vector<ResultsDirectory>& all);

}  // namespace geneva::post
