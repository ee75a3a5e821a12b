#pragma once

#include <array>

#include "loads/pin/cylinder_kernel_table.h"

namespace geneva::loads {

/// How much more a line load on a generator of a solid round cylinder moves this generator than
/// that of a half-space, beside the bending and shearing of a beam (doc/theory.md, "The pin in
/// space without finite elements").
class CylinderKernel {
 public:
  /// Poisson's ratio from 0 to 0.5.
  /// @throws base::InputError beyond
  explicit CylinderKernel(double poissons_ratio);

  /// V(z), odd: displacement times E at z = 0 of a cylinder of radius 1 under the line load 1 from
  /// z = 0 to z. To 1e-5 of its scale.
  [[nodiscard]] double integral(double z) const;

  /// s in the flexibility s/(G A) of the shear that the beam has: (7 - 8 nu^2)/(6 (1 + nu)^2); load
  /// and displacement are of the same generator, so that it is not Cowper's.
  [[nodiscard]] double shear_factor() const;

 private:
  double poissons_ratio_;
  std::array<double, n_kernel_places> values_{};  ///< V without its logarithm at 0
  std::array<double, n_kernel_places> slopes_{};
};

}  // namespace geneva::loads
