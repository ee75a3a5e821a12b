#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include "fem/problem.h"

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

/// Hooke's law for the in-plane strain and the hoop strain u_r/r (0 unless axisymmetric).
PlaneStress stress(const Lame& lame, PlaneKind plane, const dealii::SymmetricTensor<2, 2>& strain,
                   double hoop_strain);

/// Hooke's law in 3-D.
dealii::SymmetricTensor<2, 3> stress(const Lame& lame, const dealii::SymmetricTensor<2, 3>& strain);

/// Out-of-plane measure of a point: the thickness, or 2 pi r in an axisymmetric model; 1 in 3-D.
template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const dealii::Point<dim>& point);

}  // namespace geneva::fem
