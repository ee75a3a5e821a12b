#pragma once

#include <vector>

#include "fem/problem/problem.h"

namespace geneva::fem {

/// Shares of a problem's loads that act at one instant, in the order of the problem; where a list
/// is empty, all of them act in full.
struct Load {
  std::vector<double> body_forces;    ///< by body
  std::vector<double> surface_loads;  ///< by surface load
  std::vector<double> ties;           ///< by tie, of its force
  std::vector<double> supports;       ///< by support, of its prescribed displacements
};

bool operator==(const Load& one, const Load& other);

/// The problem with what acts at the instant in full.
/// @throws std::invalid_argument if a list has another length than the problem's
template <int dim>
Problem<dim> at_instant(const Problem<dim>& problem, const Load& load);

}  // namespace geneva::fem
