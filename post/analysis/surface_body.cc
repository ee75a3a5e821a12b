#include "post/analysis/surface_body.h"

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

template <int dim>
double curvature(const fem::Solution<dim>& solution, const int circle, const bool is_convex) {
  if (circle < 0) return 0.;
  const double radius = solution.mesh.circles[static_cast<std::size_t>(circle)].radius;
  return is_convex ? 1. / radius : -1. / radius;
}

template unsigned int body_of(const fem::Solution<2>&, const std::string&);
template unsigned int body_of(const fem::Solution<3>&, const std::string&);
template loads::Elastic material_of(const fem::Solution<2>&, const std::string&);
template loads::Elastic material_of(const fem::Solution<3>&, const std::string&);

template double curvature(const fem::Solution<2>&, int, bool);
template double curvature(const fem::Solution<3>&, int, bool);

}  // namespace geneva::post
