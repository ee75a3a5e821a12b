#pragma once

#include <mpi.h>

#include <variant>

#include "fem/solution.h"
#include "model/model.h"
#include "post/analysis/results.h"
#include "post/analysis/run_report.h"

namespace geneva::api {

/// A case solved and analysed.
template <int dim>
struct AnalysedModel {
  model::Model<dim> model;
  fem::Solution<dim> solution;
  post::Results<dim> results;
};

/// What stands behind an Analysis.
struct AnalysisState {
  MPI_Comm communicator;
  std::variant<AnalysedModel<2>, AnalysedModel<3>> analysed;
  post::RunReport report;  ///< without the time that writing takes
};

}  // namespace geneva::api
