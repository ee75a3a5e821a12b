#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <Eigen/Core>
#include <type_traits>

#include "fem/problem/problem.h"

namespace geneva::fem {

/// Lame constants of an isotropic material in a plane model (Timoshenko and Goodier, Theory of
/// Elasticity, 7 - 17).
struct Lame {
  double lambda;        ///< nu E/((1 + nu)(1 - 2 nu)) [Pa]
  double mu;            ///< E/(2 (1 + nu)) [Pa]
  double lambda_plane;  ///< acts on the in-plane strains: lambda, or 2 lambda mu/(lambda + 2 mu) in
                        ///< plane stress [Pa]
};

Lame lame(const Material& material, PlaneKind plane);

/// Stress [Pa], tension positive: the in-plane tensor and the normal stress out of the plane.
struct PlaneStress {
  dealii::SymmetricTensor<2, 2> in_plane;
  double out_of_plane;  ///< sigma_zz; in an axisymmetric model the hoop stress
};

/// Stress at a point [Pa], tension positive.
template <int dim>
using Stress = std::conditional_t<dim == 2, PlaneStress, dealii::SymmetricTensor<2, 3>>;

/// Independent components of a stress or strain: xx, yy, out of plane, xy; in 3-D xx, yy, zz, xy,
/// xz, yz.
template <int dim>
constexpr unsigned int n_stress_components = dim == 2 ? 4 : 6;

/// Those components; of a strain the shears are twice the tensor's, so that stress . strain is
/// work.
template <int dim>
using StressVector = Eigen::Matrix<double, n_stress_components<dim>, 1>;

/// The stress whose components, in that order, component(i) gives.
template <int dim, typename Component>
Stress<dim> assembled_stress(const Component& component) {
  Stress<dim> stress;
  if constexpr (dim == 2) {
    stress.in_plane[0][0] = component(0);
    stress.in_plane[1][1] = component(1);
    stress.out_of_plane = component(2);
    stress.in_plane[0][1] = component(3);
  } else {
    for (unsigned int i = 0; i < 3; ++i) stress[i][i] = component(i);
    stress[0][1] = component(3);
    stress[0][2] = component(4);
    stress[1][2] = component(5);
  }
  return stress;
}

/// Out-of-plane measure of a point: the thickness, or 2 pi r in an axisymmetric model; 1 in 3-D.
template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const dealii::Point<dim>& point);

}  // namespace geneva::fem
