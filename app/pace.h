#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace geneva::app {

/// How long equal things take that are done one after the other, from when it is made.
class Pace {
 public:
  /// "; about 12 s left", from what the first ones took; empty where that is next to nothing.
  [[nodiscard]] std::string time_left(std::size_t done, std::size_t of) const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace geneva::app
