#pragma once

#include "fem/problem/problem.h"

namespace geneva::fem {

bool operator==(const Load& one, const Load& other);

/// The problem with what acts at the instant in full.
/// @throws std::invalid_argument if a list has another length than the problem's
template <int dim>
Problem<dim> at_instant(const Problem<dim>& problem, const Load& load);

}  // namespace geneva::fem
