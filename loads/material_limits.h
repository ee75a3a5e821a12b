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
  double axis_ratio;          ///< 0: a line; 1: a circle; between them an ellipse's b/a
  double friction;            ///< mu of gross sliding, >= 0; of lines
  double width_per_pressure;  ///< half-width or radius over peak pressure [m/Pa]

  [[nodiscard]] bool is_line() const { return axis_ratio == 0.; }
  [[nodiscard]] bool is_circle() const { return axis_ratio == 1.; }
};

/// First yield and shakedown of a body whose yield strength is known, of a hardened one those of
/// layer and core; and what the flanks of its material bear.
/// @param kind none where no closed form describes the contact: the last one alone. The same where
/// the limits of yield are not known: of lines beyond mu = 1, of circles and ellipses with
/// friction, of ellipses with a hardened layer
std::vector<MaterialLimit> material_limits(const TouchingBody& body,
                                           const std::optional<ContactKind>& kind,
                                           const Allowables& allowed);

}  // namespace geneva::loads
