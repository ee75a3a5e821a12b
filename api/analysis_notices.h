#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::api {

/// The case, its mechanism and load, in a line or three.
template <int dim>
std::string heading(const model::Case& given, const model::Model<dim>& model);

/// What the user should know of a solution before trusting its figures.
template <int dim>
std::vector<std::string> notices_of(const model::Case& given, const fem::Solution<dim>& solution,
                                    const post::Results<dim>& results);

/// What the user should know of a pin's line contacts beside the finite elements: where they stand
/// in the closed forms' place, and which of both to doubt where they differ by more than both their
/// errors.
std::vector<std::string> line_notices(const post::PinReport& pin, const fem::Solution<3>& solution,
                                      const post::Results<3>& results);

/// What was reached, what was wanted, why the refinement ended and what to try; empty if it
/// converged.
template <int dim>
std::string shortfall(const fem::Solution<dim>& solution, double accuracy);

/// Where the wheel's own inertia leaves little of the pin's moment, what is left of it is not that
/// of a rigid wheel: the wall gives way, and the pressure leans towards one side.
std::vector<std::string> torque_notices(const post::MechanismReport& mechanism,
                                        base::UnitSystem units);

}  // namespace geneva::api
