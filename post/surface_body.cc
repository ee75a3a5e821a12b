#include "post/surface_body.h"

#include <algorithm>

namespace geneva::post {

template <int dim>
unsigned int body_of(const fem::Solution<dim>& solution, const std::string& surface) {
  const auto& names = solution.mesh.surfaces;
  const auto id =
      static_cast<unsigned int>(std::find(names.begin(), names.end(), surface) - names.begin());
  return *mesh::bodies_of(solution.mesh, id).begin();
}

template <int dim>
loads::Elastic material_of(const fem::Solution<dim>& solution, const std::string& surface) {
  const fem::Material& material = solution.problem.bodies[body_of(solution, surface)].material;
  return {material.youngs_modulus, material.poissons_ratio};
}

template unsigned int body_of(const fem::Solution<2>&, const std::string&);
template unsigned int body_of(const fem::Solution<3>&, const std::string&);
template loads::Elastic material_of(const fem::Solution<2>&, const std::string&);
template loads::Elastic material_of(const fem::Solution<3>&, const std::string&);

}  // namespace geneva::post
