#include "post/json_values.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace geneva::post {

using nlohmann::json;

json quantity(const double value, const char* unit) {
  if (!std::isfinite(value)) return nullptr;
  return {{"value", value}, {"unit", unit}};
}

json finite(const double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

}  // namespace geneva::post
