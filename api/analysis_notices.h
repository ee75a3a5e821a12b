#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "post/analysis/results.h"

namespace geneva::api {

/// The case, its mechanism and load, in a line or three.
template <int dim>
std::string heading(const model::Case& given, const model::Model<dim>& model);

/// What the user should know of a solution before trusting its figures.
template <int dim>
std::vector<std::string> notices_of(const model::Case& given, const fem::Solution<dim>& solution,
                                    const post::Results<dim>& results);

/// What was reached, what was wanted, why the refinement ended and what to try; empty if it
/// converged.
template <int dim>
std::string shortfall(const fem::Solution<dim>& solution, double accuracy);

}  // namespace geneva::api
