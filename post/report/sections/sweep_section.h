#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The figures of a case over some of its parameters, from sweep.json.
AnsweredPart sweep_part(const ResultsDirectory& results);

}  // namespace geneva::post
