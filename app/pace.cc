#include "app/pace.h"

#include <fmt/format.h>

namespace geneva::app {

std::string Pace::time_left(const std::size_t done, const std::size_t of) const {
  if (done == 0 || done >= of) return "";
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double left = elapsed.count() * static_cast<double>(of - done) / static_cast<double>(done);
  return left < 1. ? "" : fmt::format("; about {:.0f} s left", left);
}

}  // namespace geneva::app
