#pragma once

#include "base/errors.h"
#include "fem/problem/stop.h"
#include "model/input/case_file.h"
#include "model/input/settings.h"
#include "model/input/starter_case.h"

namespace geneva {

/// Everything that a case directory asks for, SI units.
using model::Case;
using model::read_case;

/// A case in which a program sets parameters.
using model::case_with;
using model::ParameterText;
using model::Setting;

/// What may be thrown at a user: a wrong case, or a machine that cannot do what is asked for.
using base::InputError;
/// A limit that the case sets was reached before there was a result.
using base::LimitReached;

}  // namespace geneva
