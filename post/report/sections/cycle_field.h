#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "post/report/results/results_directory.h"

namespace geneva::post {

/// The field of a cycle, played with the mechanism or over load steps: the place on the page, and
/// what its script reads.
struct CycleField {
  std::string html;
  nlohmann::json data;
};

/// Nothing without cycle_view.json or load_steps_view.json.
CycleField cycle_field(const ResultsDirectory& results);

}  // namespace geneva::post
