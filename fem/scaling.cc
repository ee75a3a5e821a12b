#include "fem/scaling.h"

#include <algorithm>
#include <limits>

namespace geneva::fem {

Scales scales_of(const Problem& problem, const mesh::MeshData<2>& mesh) {
  double extent = 0.;
  for (const std::size_t component : {0U, 1U}) {
    double lowest = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for (const auto& vertex : mesh.vertices) {
      lowest = std::min(lowest, vertex[component]);
      highest = std::max(highest, vertex[component]);
    }
    extent = std::max(extent, highest - lowest);
  }
  double modulus = 0.;
  for (const Body& body : problem.bodies) modulus = std::max(modulus, body.material.youngs_modulus);
  return {extent, modulus};
}

Problem scaled(const Problem& problem, const Scales& scales) {
  Problem result = problem;
  result.thickness /= scales.length;
  for (Body& body : result.bodies) {
    body.material.youngs_modulus /= scales.stress;
    for (double& component : body.force.uniform) component *= scales.length / scales.stress;
    body.force.rotation.inertia /= scales.force() * scales.length;
  }
  for (Support& support : result.supports)
    for (auto& component : support.displacement)
      if (component) *component /= scales.length;
  for (SurfaceLoad& load : result.loads) {
    load.pressure /= scales.stress;
    for (double& component : load.traction) component /= scales.stress;
  }
  for (RigidTie& tie : result.ties) tie.force /= scales.force();
  return result;
}

}  // namespace geneva::fem
