#pragma once

#include <optional>

#include "model/input/case_file.h"
#include "model/model.h"
#include "post/analysis/figures.h"
#include "post/analysis/run_report.h"

namespace geneva::api {

/// What the report says of the mechanism; nothing for a geometry of the user's.
template <int dim>
std::optional<post::MechanismReport> mechanism_report(const model::Model<dim>& model,
                                                      const model::Case& given,
                                                      const fem::Solution<dim>& solution,
                                                      const post::Results<dim>& results);

/// The figures of the closing table on one mesh of a run.
template <int dim>
post::RunFigures run_figures(const model::Model<dim>& model, const model::Case& given,
                             const fem::Solution<dim>& solution);

}  // namespace geneva::api
