#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::model {

/// A short mark of what a case is about: its model, the model's subsection and the files named
/// there. Results with equal marks and output units belong together.
/// @param completed the case file with every default filled in
/// @param model "mechanism", "geometry" or "synthesis"
/// @param inputs files that the case reads, beside case.prm
std::string content_of(const std::string& completed, const std::string& model,
                       const std::vector<std::filesystem::path>& inputs);

}  // namespace geneva::model
