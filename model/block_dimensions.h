#pragma once

#include "loads/wheel/local_outline.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// Pin and block of slot wall, with Contact model = local.
loads::LocalDimensions block_dimensions(const MechanismCase& mechanism,
                                        const MechanismSizes& sizes);

}  // namespace geneva::model
