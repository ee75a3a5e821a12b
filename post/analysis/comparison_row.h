#pragma once

#include <optional>
#include <string>

#include "base/units.h"

namespace geneva::post {

/// One figure of a run beside what others say of it; SI units, what is missing does not exist.
struct ComparisonRow {
  std::string quantity;
  base::Dimension dimension;
  std::optional<double> computed;
  std::optional<double> error;  ///< of it, estimated, relative
  bool is_bounded;              ///< false: it grows from mesh to mesh, and there is no such value
  std::optional<double> closed_form;
  std::optional<double> published;
};

}  // namespace geneva::post
