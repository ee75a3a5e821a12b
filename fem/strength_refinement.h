#pragma once

#include <vector>

#include "fem/singular_places.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

/// Beside a contact: flags cells outside of its own field over which the stress varies by more than
/// a share of the body's maximum von Mises stress, none that is flagged already or bounds the
/// contact.
/// @param of_body whether a body's cells are wanted finer
/// @param most_share of the maximum; less where no cell varies by so much
/// @param accuracy wanted relative error of the maxima, > 0
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_for_strength(const Solution<dim>& solution, const NodalStress<dim>& stress,
                               const std::vector<SingularPlace<dim>>& singular,
                               const std::vector<bool>& of_body, double most_share,
                               double accuracy);

}  // namespace geneva::fem
