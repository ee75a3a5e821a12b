#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loads/allowables.h"

namespace geneva::loads {

/// A peak contact pressure that a material in contact stands.
struct MaterialLimit {
  enum class Kind { first_yield, shakedown, flanks };

  Kind kind;
  std::string name;  ///< "first yield, wheel"
  double pressure;   ///< [Pa]
  std::string meaning;
};

/// One of two bodies in contact.
struct TouchingBody {
  std::string name;
  double poissons_ratio;  ///< -1 < nu < 0.5
};

/// A contact whose closed form is known.
struct ContactKind {
  bool is_line;               ///< else a circle
  double friction;            ///< mu of gross sliding, >= 0; of lines
  double width_per_pressure;  ///< half-width or radius over peak pressure [m/Pa]
};

/// First yield and shakedown of a body whose yield strength is known, of a hardened one those of
/// layer and core; and what the flanks of its material bear.
/// @param kind none where no closed form describes the contact: the last one alone. Beyond mu = 1,
/// of which the limits of yield are not known, the same
std::vector<MaterialLimit> material_limits(const TouchingBody& body,
                                           const std::optional<ContactKind>& kind,
                                           const Allowables& allowed);

}  // namespace geneva::loads
