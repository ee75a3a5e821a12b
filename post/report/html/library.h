#pragma once

#include <optional>
#include <string>
#include <vector>

namespace geneva::post {

/// JavaScript that the interactive parts of a report need, from the machine's packages.
struct Libraries {
  std::optional<std::string> charts;    ///< Chart.js
  std::optional<std::string> graphics;  ///< three.js with its orbit controls
  std::vector<std::string> missing;     ///< packages that would have to be installed
};

/// Reads them from /usr/share/javascript, or from the directory that the environment variable
/// GENEVA_JAVASCRIPT names.
Libraries installed_libraries();

}  // namespace geneva::post
