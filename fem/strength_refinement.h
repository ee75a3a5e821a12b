#pragma once

#include <vector>

#include "fem/singular_places.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

/// Beside a contact in the plane: flags cells outside of its own field over which the stress varies
/// by more than a share of the body's maximum von Mises stress, none that is flagged already or
/// bounds the contact.
/// @param wanted the bodies that have any are refined
/// @param most_share of the maximum; less where no cell varies by so much
/// @param accuracy wanted relative error of the maxima, > 0
/// @return number of flagged cells on all ranks
unsigned int flag_in_plane(const Solution<2>& solution, const NodalStress<2>& stress,
                           const std::vector<SingularPlace<2>>& singular,
                           const WantedMaxima<2>& wanted, double most_share, double accuracy);

/// Beside a contact in 3-D: flags the cells that leave most open of the bodies' wanted maxima,
/// see flag_open(), and those that may hide one; none that bounds the contact.
/// @param accuracy wanted relative error of the maxima, > 0
/// @return number of flagged cells on all ranks
unsigned int flag_in_space(const Solution<3>& solution, const NodalStress<3>& stress,
                           const std::vector<SingularPlace<3>>& singular,
                           const WantedMaxima<3>& wanted, double accuracy, MeshFor next);

}  // namespace geneva::fem
