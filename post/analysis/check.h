#pragma once

#include <string>

namespace geneva::post {

/// Something that must be small in a sound result.
struct Check {
  std::string name;
  std::string meaning;  ///< what the value is
  double value;
  double limit;

  [[nodiscard]] bool is_passed() const { return value <= limit; }
};

}  // namespace geneva::post
