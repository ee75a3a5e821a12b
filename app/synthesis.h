#pragma once

#include <filesystem>

#include "model/input/case_file.h"
#include "post/output/synthesis_output.h"

namespace geneva::app {

/// Dimensions of the linkage that a case asks for (Lecture 4).
/// @throws base::InputError if the case has another model, or where the loads room does
post::SynthesisReport make_synthesis(const model::Case& given);

/// Does what `geneva synthesize` does: prints the linkage or linkages and writes synthesis.json and
/// synthesis.csv.
/// @param output where the files go; empty: results in the case's directory
/// @return exit code: 0, or 2 if no path generator was found
/// @throws base::InputError where make_synthesis() does, or if the files cannot be written
int synthesize_case(const std::filesystem::path& case_directory,
                    const std::filesystem::path& output);

}  // namespace geneva::app
