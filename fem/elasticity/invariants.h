#pragma once

#include <array>

#include "fem/elasticity/elasticity.h"

namespace geneva::fem {

/// Principal stresses [same unit], largest first; the out-of-plane stress is one of them.
std::array<double, 3> principal_stresses(const PlaneStress& stress);
std::array<double, 3> principal_stresses(const dealii::SymmetricTensor<2, 3>& stress);
/// sqrt(((s1-s2)^2 + (s2-s3)^2 + (s3-s1)^2)/2)
double von_mises(const std::array<double, 3>& principal);
/// (s1 - s3)/2
double max_shear(const std::array<double, 3>& principal);
/// Maximum shear stress in the plane of the model, which is what Hertz's 0.300 p0 speaks of.
double in_plane_shear(const PlaneStress& stress);

}  // namespace geneva::fem
