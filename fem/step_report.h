#pragma once

namespace geneva::fem {

/// Told after every active-set step, on every rank: refinement level, unknowns, step and its linear
/// iterations.
struct StepReport {
  unsigned int level;
  unsigned int dofs;
  unsigned int step;
  unsigned int linear_iterations;
};

}  // namespace geneva::fem
