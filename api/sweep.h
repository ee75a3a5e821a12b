#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
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

/// A sweep of these cases without any figures yet.
/// @param command "run", "estimate", "kinematics" or "design"
Sweep begun_sweep(const Case& given, const std::vector<model::Variation>& variations,
                  const std::vector<SweepCase>& cases, const std::string& command);

/// What the command of a sweep says of a case that it refuses.
void refuse_point(post::SweepPoint& point, const std::string& message);

/// Figures of every point, by figures_of().
void work_out(Sweep& sweep, const std::vector<SweepCase>& cases);

/// Refuses a sweep of which no point has any figures.
/// @throws InputError with what is said of the first point
void require_figures(const Sweep& sweep);

/// Figures of a case by `geneva estimate`, `kinematics` or `design`.
/// @param command one of these
/// @throws InputError where the command does
std::vector<post::SweepFigure> figures_of(const Case& given, const std::string& command);

/// Figures of a run, from its summary.json.
/// @throws InputError if there is none, or it is damaged
std::vector<post::SweepFigure> figures_of_run(const std::filesystem::path& results);

/// Figures of a run.
/// @param summary as summary() of an analysis gives it
std::vector<post::SweepFigure> figures_of_summary(const nlohmann::json& summary);

/// The points and the figures that change most, in the case's units.
std::string table(const Sweep& sweep);

/// Writes sweep.json, sweep.csv and the report.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Sweep& sweep, const std::filesystem::path& directory);

}  // namespace geneva
