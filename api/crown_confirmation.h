#pragma once

#include <mpi.h>

#include "api/analysis.h"
#include "api/crown.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// Solves the pin found by finite elements, and adds that to what is known of it. All ranks call
/// it.
/// @param mesher already started, on rank 0; nothing: it is started when it is needed
/// @return whether it is as accurate as the case asks
/// @param progress told of steps, meshes and other work
/// @throws InputError on all ranks
bool confirm(Crown& crown, MPI_Comm communicator, mesh::Mesher* mesher = nullptr,
             const Progress& progress = {});

}  // namespace geneva
