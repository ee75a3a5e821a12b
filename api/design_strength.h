#pragma once

#include <mpi.h>

#include <functional>
#include <string>

#include "api/design.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// Solves the wheel by finite elements for the best diameter and four on either side, from 0.58
/// to 1.73 of it, and adds their maximum stresses away from the contact to the design: the wheel
/// that is best for the contact may not be best for its arms. Diameters for which no wheel can be
/// drawn or solved are left out, and a notice says why. All ranks call it.
/// @param mesher already started, on rank 0; nothing: it is started when it is needed
/// @param tell of every wheel that is done: how many are, and of how many; may be empty. What it
/// throws ends the design, see end_together()
/// @throws InputError on all ranks if no wheel can be drawn or solved
void add_strength(Design& design, MPI_Comm communicator, mesh::Mesher* mesher = nullptr,
                  const std::function<void(int, int)>& tell = {});

}  // namespace geneva
