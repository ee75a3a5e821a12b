#pragma once

#include "model/mechanism_state.h"

namespace geneva::model {

/// By which a moment about the slot's axis turns the driving wall beside the pin [rad/(N m)], more
/// than a block 8 t wide and 4 t deep would, t the wheel's thickness (loads/pin/slab_kernel.h): the
/// difference of two plates, of which one is the wheel, held where it is held, or the block of slot
/// wall.
/// @throws base::InputError where the loads room does
double wheel_twist(const MechanismCase& mechanism, const MechanismState& state);

}  // namespace geneva::model
