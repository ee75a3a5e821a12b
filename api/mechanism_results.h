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

/// Moment that a whole wheel's shaft takes [N m]; nothing of a block.
template <int dim>
std::optional<double> bore_torque(const model::Model<dim>& model,
                                  const model::MechanismCase& mechanism,
                                  const fem::Solution<dim>& solution);

/// The figures of the closing table on one mesh of a run.
template <int dim>
post::RunFigures run_figures(const model::Model<dim>& model, const model::Case& given,
                             const fem::Solution<dim>& solution);

}  // namespace geneva::api
