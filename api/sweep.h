#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/written.h"
#include "model/input/variation.h"
#include "post/output/sweep_output.h"

namespace geneva {

/// A case over some of its parameters.
struct Sweep {
  Case given;  ///< as it stands in its directory
  post::SweepReport report;
};

/// A combination of values as a case of its own; nothing where it is refused.
struct SweepCase {
  std::vector<std::string> values;
  std::optional<Case> given;
  std::string refusal;
};

/// The case with every combination of the variations' values.
/// @throws InputError if no combination is a case (with what is said of the first), or a variation
/// is of a text that changes no figure
std::vector<SweepCase> sweep_cases(const Case& given,
                                   const std::vector<model::Variation>& variations);

/// Figures of a case by `geneva estimate`, `kinematics` or `design`.
/// @param command one of these
/// @throws InputError where the command does
std::vector<post::SweepFigure> figures_of(const Case& given, const std::string& command);

/// Figures of a run, from its summary.json.
/// @throws InputError if there is none, or it is damaged
std::vector<post::SweepFigure> figures_of_run(const std::filesystem::path& results);

/// Writes sweep.json, sweep.csv and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Sweep& sweep, const std::filesystem::path& directory);

}  // namespace geneva
