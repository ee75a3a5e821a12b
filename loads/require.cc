#include "loads/require.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/errors.h"

namespace geneva::loads {

namespace {

std::string suffix(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

}  // namespace

void require_positive(const char* quantity, double value, const char* unit) {
  if (std::isfinite(value) && value > 0.) return;
  throw base::InputError(
      fmt::format("{0} is {1:.6g}{2}: it must be positive and finite; give a {0} greater than 0{2}",
                  quantity, value, suffix(unit)));
}

void require_positive_length(const char* quantity, double length) {
  require_positive(quantity, 1e3 * length, "mm");
}

void require_not_negative(const char* quantity, double value, const char* unit) {
  if (std::isfinite(value) && value >= 0.) return;
  throw base::InputError(fmt::format(
      "{0} is {1:.6g}{2}: it must be finite and not negative; give a {0} of 0{2} or more", quantity,
      value, suffix(unit)));
}

void require_finite(const char* quantity, double value, const char* unit) {
  if (std::isfinite(value)) return;
  throw base::InputError(fmt::format("{0} is {1}{2}: it must be finite; give a finite {0}",
                                     quantity, value, suffix(unit)));
}

int require_stations(int stations) {
  if (stations >= 3 && stations <= 24) return stations;
  throw base::InputError(fmt::format(
      "number of stations is {}: a Geneva wheel has 3 to 24; give a number in this range",
      stations));
}

}  // namespace geneva::loads
