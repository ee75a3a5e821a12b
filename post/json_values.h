#pragma once

#include <nlohmann/json_fwd.hpp>

#include "post/units.h"

namespace geneva::post {

/// {"value": ..., "unit": ...}; null, since JSON knows no infinity, if the value is not finite.
nlohmann::json quantity(double value, const char* unit);

/// The same in the SI unit of the dimension.
nlohmann::json quantity(double value, Dimension dimension);

/// The number, or null if it is not finite.
nlohmann::json finite(double value);

}  // namespace geneva::post
