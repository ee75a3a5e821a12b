#pragma once

#include <string>

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// A geometry over its load steps.
/// @param field as cycle_field() plays it
AnsweredPart load_steps_part(const ResultsDirectory& results, const std::string& field);

}  // namespace geneva::post
