#pragma once

#include <mpi.h>

#include "api/analysis.h"
#include "api/optimisation.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// Maximum tensile stress [Pa] of a case's wheel away from the contact, in the plane to 2 %. All
/// ranks call it.
/// @param mesher already started, on rank 0; nothing: it is started when it is needed
/// @throws InputError on all ranks, also if the wheel is not drawn
double slot_bottom_stress(const Case& given, MPI_Comm communicator, mesh::Mesher* mesher = nullptr);

/// Solves the best case by finite elements, and adds that to what is known of it. All ranks call
/// it.
/// @return whether it is as accurate as the case asks
/// @param progress told of steps, meshes and other work
/// @throws InputError on all ranks
bool confirm(Optimum& optimum, MPI_Comm communicator, mesh::Mesher* mesher = nullptr,
             const Progress& progress = {});

}  // namespace geneva
