#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The best dimensions, from optimum.json.
AnsweredPart optimum_part(const ResultsDirectory& results);

}  // namespace geneva::post
