#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "api/case.h"
#include "api/written.h"
#include "post/output/optimum_output.h"

namespace geneva {

/// The best dimensions of a case.
struct Optimum {
  Case given;
  Case best;
  post::OptimumReport report;
};

/// Whether finite elements have a part in what is to be least or in its limits.
bool wants_slot_bottom(const Case& given);

/// Looks for the free dimensions of a case with which its goal is least under its limits: closed
/// forms on a grid (of more than two dimensions a Halton sequence) over the bounds, then from the
/// best places M. J. D. Powell's COBYLA (1994) by NLopt.
/// @param slot_bottom maximum tensile stress [Pa] of a case's wheel; wanted if
/// wants_slot_bottom(), with which there are fewer candidates
/// @param tell called now and then with the number of candidates worked out so far
/// @throws InputError if the case leaves nothing free, a free dimension is none, or no candidate
/// keeps the limits (with the one that comes nearest)
Optimum optimise(const Case& given, const std::function<double(const Case&)>& slot_bottom = {},
                 const std::function<void(int)>& tell = {});

/// Dimensions, figures and what binds, in the case's units.
std::string table(const Optimum& optimum);

/// Writes optimum.json, optimum.csv and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Optimum& optimum, const std::filesystem::path& directory);

}  // namespace geneva
