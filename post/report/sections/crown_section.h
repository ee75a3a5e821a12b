#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The pin as it is beside the one with the most even line load, from crown.json and crown.csv.
AnsweredPart crown_part(const ResultsDirectory& results);

}  // namespace geneva::post
