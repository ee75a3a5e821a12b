#include "fem/elasticity/invariants.h"

#include <algorithm>
#include <cmath>

namespace geneva::fem {

std::array<double, 3> principal_stresses(const PlaneStress& stress) {
  const double mean = 0.5 * (stress.in_plane[0][0] + stress.in_plane[1][1]);
  const double radius =
      std::hypot(0.5 * (stress.in_plane[0][0] - stress.in_plane[1][1]), stress.in_plane[0][1]);
  std::array<double, 3> principal{mean + radius, mean - radius, stress.out_of_plane};
  std::sort(principal.rbegin(), principal.rend());
  return principal;
}

std::array<double, 3> principal_stresses(const dealii::SymmetricTensor<2, 3>& stress) {
  return dealii::eigenvalues(stress);
}

double von_mises(const std::array<double, 3>& principal) {
  const auto& [s1, s2, s3] = principal;
  return std::sqrt(0.5 * ((s1 - s2) * (s1 - s2) + (s2 - s3) * (s2 - s3) + (s3 - s1) * (s3 - s1)));
}

double max_shear(const std::array<double, 3>& principal) {
  return 0.5 * (principal[0] - principal[2]);
}

double in_plane_shear(const PlaneStress& stress) {
  return std::hypot(0.5 * (stress.in_plane[0][0] - stress.in_plane[1][1]), stress.in_plane[0][1]);
}

}  // namespace geneva::fem
