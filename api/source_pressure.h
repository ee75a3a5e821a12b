#pragma once

#include <vector>

#include "api/found_steps.h"
#include "post/output/cycle_fields.h"
#include "post/output/envelope.h"

namespace geneva::api {

/// The greatest contact pressure of all steps at the nodes of source surfaces, and its step.
/// @param fields of the mesh of the steps, of all ranks
post::PressureEnvelope pressure_envelope(const std::vector<FoundStep>& steps,
                                         const post::NodalFields& fields);

}  // namespace geneva::api
