#include "fem/elasticity.h"

namespace geneva::fem {

Lame lame(const Material& material, const PlaneKind plane) {
  const double E = material.youngs_modulus;
  const double nu = material.poissons_ratio;
  const double lambda = nu * E / ((1. + nu) * (1. - 2. * nu));
  const double mu = E / (2. * (1. + nu));
  const double lambda_plane =
      plane == PlaneKind::plane_stress ? 2. * lambda * mu / (lambda + 2. * mu) : lambda;
  return {lambda, mu, lambda_plane};
}

dealii::SymmetricTensor<2, 3> stress(const Lame& lame,
                                     const dealii::SymmetricTensor<2, 3>& strain) {
  return lame.lambda * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>() +
         2. * lame.mu * strain;
}

PlaneStress stress(const Lame& lame, const PlaneKind plane,
                   const dealii::SymmetricTensor<2, 2>& strain, const double hoop_strain) {
  const double dilatation = dealii::trace(strain) + hoop_strain;
  PlaneStress result;
  result.in_plane =
      lame.lambda_plane * dilatation * dealii::unit_symmetric_tensor<2>() + 2. * lame.mu * strain;
  result.out_of_plane = plane == PlaneKind::plane_stress
                            ? 0.
                            : lame.lambda_plane * dilatation + 2. * lame.mu * hoop_strain;
  return result;
}

template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const dealii::Point<dim>& point) {
  if (dim == 3) return 1.;
  return problem.plane == PlaneKind::axisymmetric ? 2. * dealii::numbers::PI * point[0]
                                                  : problem.thickness;
}

template double out_of_plane_measure(const Problem<2>&, const dealii::Point<2>&);
template double out_of_plane_measure(const Problem<3>&, const dealii::Point<3>&);

}  // namespace geneva::fem
