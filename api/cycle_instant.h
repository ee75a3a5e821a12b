#pragma once

#include <mpi.h>

#include "api/case.h"
#include "loads/motion/pin_load.h"
#include "post/output/cycle_output.h"
#include "post/output/nodal_fields.h"

namespace geneva::mesh {
class Mesher;
}

namespace geneva::api {

/// Whether the pin touches the slot's wall itself, and not its end at the rim: a corner, where no
/// pressure is bounded.
bool touches_wall(const Case& given, const loads::PinLoad& load);

/// Solves the contact at an instant, on the wall that carries, as `geneva run` does; what cannot be
/// solved says why.
/// @param mesher on rank 0
/// @return the fields on this rank, of the wheel as it stands, in whichever wall's sense it turns;
/// empty without a contact
post::NodalFields solve_instant(post::CyclePoint& point, const Case& given, MPI_Comm communicator,
                                mesh::Mesher* mesher);

}  // namespace geneva::api
