#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/units.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The mechanism drawn to scale at the analysed driver angle, a slider that turns it, its lengths,
/// and its curves over the cycle.
/// @param mechanism what mechanism.json holds
ReportPart mechanism_part(const nlohmann::json& mechanism, base::UnitSystem units);

}  // namespace geneva::post
