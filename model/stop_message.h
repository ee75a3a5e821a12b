#pragma once

#include <string>

#include "fem/problem/stop.h"

namespace geneva::model {

/// What ended the refinement early and what to try, by the names of the case file; empty if it
/// converged.
std::string message_of(const fem::Stop& stop);

}  // namespace geneva::model
