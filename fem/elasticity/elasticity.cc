#include "fem/elasticity/elasticity.h"

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

template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const dealii::Point<dim>& point) {
  if (dim == 3) return 1.;
  return problem.plane == PlaneKind::axisymmetric ? 2. * dealii::numbers::PI * point[0]
                                                  : problem.thickness;
}

template double out_of_plane_measure(const Problem<2>&, const dealii::Point<2>&);
template double out_of_plane_measure(const Problem<3>&, const dealii::Point<3>&);

}  // namespace geneva::fem
