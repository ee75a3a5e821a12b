#pragma once

#include <optional>

#include "app/case_file.h"
#include "app/model.h"
#include "post/analysis/figures.h"
#include "post/analysis/run_report.h"

namespace geneva::app {

/// What the report says of the mechanism; nothing for a geometry of the user's.
template <int dim>
std::optional<post::MechanismReport> mechanism_report(const Model<dim>& model, const Case& given,
                                                      const fem::Solution<dim>& solution,
                                                      const post::Results<dim>& results);

/// The figures of the closing table on one mesh of a run.
template <int dim>
post::RunFigures run_figures(const Model<dim>& model, const Case& given,
                             const fem::Solution<dim>& solution);

}  // namespace geneva::app
