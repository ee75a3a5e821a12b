#pragma once

#include <filesystem>
#include <string>

#include "api/case.h"
#include "api/written.h"
#include "post/output/synthesis_output.h"

namespace geneva {

/// Dimensions of the linkage that a case asks for.
struct Synthesis {
  Case given;
  post::SynthesisReport report;
  std::string shortfall;  ///< why there is no linkage, and what to try; empty if there is one
};

/// Dimensions of the linkage that a case asks for (Lecture 4).
/// @throws InputError if the case has another model, or there is no such linkage
Synthesis synthesize(const Case& given);

/// The linkages as `geneva synthesize` prints them, in the case's units.
std::string table(const Synthesis& synthesis);

/// Writes synthesis.json and synthesis.csv.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Synthesis& synthesis, const std::filesystem::path& directory);

}  // namespace geneva
