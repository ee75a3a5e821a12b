#pragma once

#include <array>
#include <cstddef>

#include "loads/pin/slab_kernel_table.h"

namespace geneva::loads {

/// How much more a line load across the edge of a plate moves this line than half-spaces with the
/// loads' images at the plate's faces (doc/theory.md, "The pin in space without finite elements").
///
/// The plate is a block 8 t wide and 4 t deep, t thick, held at its back and sides. With Legendre's
/// polynomials P_i and zeta = 2 z/t:
///
///     u(z) = 1/(E t) int sum_ij k_ij P_i(zeta) P_j(zeta') q(z') dz'
class SlabKernel {
 public:
  /// Poisson's ratio from 0 to 0.5.
  /// @throws base::InputError beyond
  explicit SlabKernel(double poissons_ratio);

  using Polynomials = std::array<double, n_slab_modes>;

  /// P_i at zeta from -1 to 1.
  static Polynomials polynomials(double zeta);

  /// k_ij; i and j are both even or both odd.
  [[nodiscard]] double entry(std::size_t i, std::size_t j) const {
    return (i % 2 == 0 ? even_ : odd_)[i / 2][j / 2];
  }

  /// sum_ij k_ij P_i(zeta) P_j(zeta'), of two places' polynomials.
  [[nodiscard]] double value(const Polynomials& here, const Polynomials& there) const;

 private:
  SlabMatrix even_{};  ///< of i and j = 0, 2, 4, ...
  SlabMatrix odd_{};   ///< of i and j = 1, 3, 5, ...
};

/// Image loads at the faces of a plate are multiplied by this, so that the faces are free of shear
/// stress, too (Guilbault 2011).
double image_factor(double poissons_ratio);

}  // namespace geneva::loads
