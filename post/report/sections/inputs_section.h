#pragma once

#include <string>

#include "post/report/results/case_inputs.h"
#include "post/report/results/results_directory.h"

namespace geneva::post {

/// The value of an input as print has it; texts and names of materials stand as they are.
std::string shown_value(const CaseInput& input);

/// The case's inputs; those that follow from a rule with the value that was worked out.
std::vector<CaseInput> inputs_of(const ResultsDirectory& results);

/// Every input of a case: materials, what the case gives, its lines word for word, and the rest;
/// what is folded on the screen is open on paper.
/// @param remark in front of them; may be empty
std::string inputs_section(const ResultsDirectory& results, const std::string& remark);

}  // namespace geneva::post
