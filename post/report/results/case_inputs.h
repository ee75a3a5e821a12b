#pragma once

#include <string>
#include <vector>

namespace geneva::post {

/// A parameter of a completed case file.
struct CaseInput {
  std::string name;  ///< with its subsections but the model's: "Wheel material/Density"
  std::string value;
  bool is_given;      ///< by the case file, be it the default or not
  bool is_published;  ///< a figure of the literature, from which nothing is worked out
};

/// All of them, in the file's order.
/// @param case_text of case.prm as a run completes it
std::vector<CaseInput> case_inputs(const std::string& case_text);

/// What the case gives, as a case file: the lines as they stand, without comments and defaults.
/// @param case_text of case.prm as a run completes it
std::string given_lines(const std::string& case_text);

}  // namespace geneva::post
