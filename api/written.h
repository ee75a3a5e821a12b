#pragma once

#include <string>
#include <vector>

namespace geneva {

/// What is worth knowing when results have been written.
struct Written {
  /// Names of the files removed that belonged to results of another case, or of this one before it
  /// was changed.
  std::vector<std::string> removed;
  /// Packages that are not installed, without which the report lacks its interactive parts.
  std::vector<std::string> missing_packages;
};

}  // namespace geneva
