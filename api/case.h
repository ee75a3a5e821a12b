#pragma once

#include "base/errors.h"
#include "fem/problem/stop.h"
#include "model/input/case_file.h"

namespace geneva {

/// Everything that a case directory asks for, SI units.
using model::Case;
using model::read_case;

/// What may be thrown at a user: a wrong case, or a machine that cannot do what is asked for.
using base::InputError;
/// A limit that the case sets was reached before there was a result.
using base::LimitReached;

}  // namespace geneva
