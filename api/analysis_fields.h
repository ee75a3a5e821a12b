#pragma once

#include "fem/solution.h"
#include "post/analysis/stress.h"
#include "post/output/nodal_fields.h"

namespace geneva::api {

/// Displacement and stress on this rank's cells.
/// @param stress at the nodes of the solution
template <int dim>
post::NodalFields fields_of(const fem::Solution<dim>& solution,
                            const post::NodalStress<dim>& stress);

/// The same with cells at round surfaces in parts that follow these, so that what is shown is
/// round.
template <int dim>
post::NodalFields rounded_fields_of(const fem::Solution<dim>& solution,
                                    const post::NodalStress<dim>& stress);

}  // namespace geneva::api
