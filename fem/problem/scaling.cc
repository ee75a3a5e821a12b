#include "fem/problem/scaling.h"

#include <algorithm>
#include <limits>

namespace geneva::fem {

template <int dim>
Scales scales_of(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  double extent = 0.;
  for (std::size_t component = 0; component < dim; ++component) {
    double lowest = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for (const auto& vertex : mesh.vertices) {
      lowest = std::min(lowest, vertex[component]);
      highest = std::max(highest, vertex[component]);
    }
    extent = std::max(extent, highest - lowest);
  }
  double modulus = 0.;
  for (const Body<dim>& body : problem.bodies)
    modulus = std::max(modulus, body.material.youngs_modulus);
  return {extent, modulus};
}

template <int dim>
Problem<dim> scaled(const Problem<dim>& problem, const Scales& scales) {
  Problem<dim> result = problem;
  result.thickness /= scales.length;
  for (Body<dim>& body : result.bodies) {  // the unit of time stays
    body.density *= scales.length * scales.length / scales.stress;
    for (double& component : body.force.acceleration) component /= scales.length;
    body.material.youngs_modulus /= scales.stress;
    for (double& component : body.force.uniform) component *= scales.length / scales.stress;
    body.force.rotation.inertia /= scales.force() * scales.length;
  }
  for (Support<dim>& support : result.supports)
    for (auto& component : support.displacement)
      if (component) *component /= scales.length;
  for (SurfaceLoad<dim>& load : result.loads) {
    load.pressure /= scales.stress;
    for (double& component : load.traction) component /= scales.stress;
  }
  for (RigidTie<dim>& tie : result.ties) tie.force /= scales.force();
  for (ContactPair& pair : result.pairs)
    if (pair.clearance)
      pair.clearance = [length = scales.length, given = pair.clearance](const double z) {
        return given(z * length) / length;
      };
  return result;
}

template Scales scales_of(const Problem<2>&, const mesh::MeshData<2>&);
template Problem<2> scaled(const Problem<2>&, const Scales&);
template Scales scales_of(const Problem<3>&, const mesh::MeshData<3>&);
template Problem<3> scaled(const Problem<3>&, const Scales&);

}  // namespace geneva::fem
