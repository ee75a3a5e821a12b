#pragma once

#include <nlohmann/json_fwd.hpp>

namespace geneva::post {

/// {"value": ..., "unit": ...}; null, since JSON knows no infinity, if the value is not finite.
nlohmann::json quantity(double value, const char* unit);

/// The number, or null if it is not finite.
nlohmann::json finite(double value);

}  // namespace geneva::post
