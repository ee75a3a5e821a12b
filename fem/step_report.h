#pragma once

namespace geneva::fem {

/// Told on every rank where a mesh begins, as step 0, and after every active-set step: refinement
/// level, unknowns, step and its linear iterations.
struct StepReport {
  unsigned int level;
  unsigned int dofs;
  unsigned int step;
  unsigned int linear_iterations;
};

}  // namespace geneva::fem
