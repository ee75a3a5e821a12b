#include "fem/elasticity/material_law.h"

namespace geneva::fem {

namespace {

template <int dim>
Tangent<dim> hookes_tangent(const Material& material, const PlaneKind plane) {
  constexpr int n_normal = 3;
  const Lame constants = lame(material, dim == 3 ? PlaneKind::plane_strain : plane);
  Tangent<dim> tangent = Tangent<dim>::Zero();
  tangent.template topLeftCorner<n_normal, n_normal>().setConstant(constants.lambda_plane);
  tangent.diagonal().array() += constants.mu;
  tangent.diagonal().template head<n_normal>().array() += constants.mu;
  if (dim == 2 && plane == PlaneKind::plane_stress) {
    tangent.row(2).setZero();
    tangent.col(2).setZero();
  }
  return tangent;
}

}  // namespace

template <int dim>
LinearElastic<dim>::LinearElastic(const Material& material, const PlaneKind plane)
    : tangent_(hookes_tangent<dim>(material, plane)) {}

template <int dim>
MaterialResponse<dim> LinearElastic<dim>::respond(const StressVector<dim>& strain,
                                                  const MaterialHistory& /*before*/) const {
  return {tangent_ * strain, tangent_, {}};
}

template <int dim>
MaterialLaws<dim> material_laws(const Problem<dim>& problem) {
  MaterialLaws<dim> laws;
  for (const Body<dim>& body : problem.bodies)
    laws.push_back(std::make_unique<const LinearElastic<dim>>(body.material, problem.plane));
  return laws;
}

template class LinearElastic<2>;
template class LinearElastic<3>;
template MaterialLaws<2> material_laws(const Problem<2>&);
template MaterialLaws<3> material_laws(const Problem<3>&);

}  // namespace geneva::fem
