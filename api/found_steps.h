#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "api/analysis.h"
#include "api/case.h"
#include "fem/solution.h"
#include "post/analysis/safety.h"
#include "post/output/load_history_output.h"
#include "post/output/nodal_fields.h"

namespace geneva::api {

/// A source node of a contact and what it carries at one step, SI units.
struct SourceNode {
  Vector place;
  unsigned int body;
  double pressure;
};

/// One load step of a mesh.
struct FoundStep {
  post::LoadStepPoint point;
  std::vector<post::SafetyRow> limits;
  std::vector<SourceNode> sources;
  post::NodalFields fields;  ///< of this rank
};

/// What was found of every load step on the last mesh that has them all.
template <int dim>
class StepCollector {
 public:
  /// @param given must outlive it
  explicit StepCollector(const Case& given) : given_(given) {}

  /// @param step index; 0 begins a mesh
  void add(std::size_t step, const fem::Solution<dim>& at_step) {
    if (step == 0) pending_.clear();
    pending_.push_back(at_step);
  }

  /// The mesh is solved.
  void take(const fem::Solution<dim>& on_mesh);

  std::vector<FoundStep> found() { return std::move(steps_); }

 private:
  const Case& given_;
  std::vector<fem::Solution<dim>> pending_;
  std::vector<FoundStep> steps_;
};

}  // namespace geneva::api
