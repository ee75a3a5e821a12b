#pragma once

#include <vector>

namespace geneva::loads {

/// What is inside of a round pin.
enum class PinInside {
  solid,
  hollow,     ///< a bore, free of traction
  held_core,  ///< a core that does not move
};

/// How much more a line load on a generator of a round cylinder moves this generator than that of a
/// half-space, beside the bending and shearing of a beam, of which a cylinder that is held at its
/// core has none (doc/theory.md, "The pin in space without finite elements").
class CylinderKernel {
 public:
  /// @param poissons_ratio from 0 to 0.5
  /// @param inner_radius of bore or core over the cylinder's: 0 to 0.7 or 0.1 to 0.9; not used of a
  /// solid one
  /// @throws base::InputError beyond
  explicit CylinderKernel(double poissons_ratio, PinInside inside = PinInside::solid,
                          double inner_radius = 0.);

  /// V(z), odd: displacement times E at z = 0 of a cylinder of radius 1 under the line load 1 from
  /// z = 0 to z. To 1e-5 of its scale; hollow or held at the core to 5e-5.
  [[nodiscard]] double integral(double z) const;

  /// s in the flexibility s/(G A) of the shear that the beam has; load and displacement are of the
  /// same generator, so that it is not Cowper's: (7 - 8 nu^2)/(6 (1 + nu)^2) of a solid cylinder.
  [[nodiscard]] double shear_factor() const;

 private:
  double poissons_ratio_;
  double inner_radius_;
  double place_step_;
  std::vector<double> places_;
  std::vector<double> values_;  ///< V without its logarithm at 0
  std::vector<double> slopes_;
};

}  // namespace geneva::loads
