#include "fem/problem/source_sides.h"

#include <algorithm>
#include <utility>

namespace geneva::fem {

namespace {

template <int dim>
const Material& material_at(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                            const std::string& surface) {
  return problem.bodies[*mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface)).begin()]
      .material;
}

}  // namespace

template <int dim>
double compliance(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                  const std::string& surface) {
  const Material& material = material_at(mesh, problem, surface);
  const double nu = problem.plane == PlaneKind::plane_stress ? 0. : material.poissons_ratio;
  return (1. - nu * nu) / material.youngs_modulus;
}

template <int dim>
double mean_poissons_ratio(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                           const ContactPair& pair) {
  const auto ratio_at = [&](const std::string& surface) {
    const double nu = material_at(mesh, problem, surface).poissons_ratio;
    return problem.plane == PlaneKind::plane_stress ? nu / (1. + nu) : nu;
  };
  const double source = compliance(mesh, problem, pair.source);
  const double target = compliance(mesh, problem, pair.target);
  return (source * ratio_at(pair.source) + target * ratio_at(pair.target)) / (source + target);
}

namespace {

template <int dim>
bool belongs_to_one_body(const mesh::MeshData<dim>& mesh, const std::string& surface) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), surface);
  return found != mesh.surfaces.end() &&
         mesh::bodies_of(mesh, static_cast<unsigned int>(found - mesh.surfaces.begin())).size() ==
             1;
}

bool is_in_one_pair(const std::vector<ContactPair>& pairs, const std::string& surface) {
  return std::count_if(pairs.begin(), pairs.end(), [&](const ContactPair& pair) {
           return pair.source == surface || pair.target == surface;
         }) == 1;
}

}  // namespace

template <int dim>
void take_softer_sources(Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  constexpr double round_off = 1e-9;
  for (ContactPair& pair : problem.pairs) {
    if (!belongs_to_one_body(mesh, pair.source) || !belongs_to_one_body(mesh, pair.target) ||
        !is_in_one_pair(problem.pairs, pair.target))
      continue;
    if (compliance(mesh, problem, pair.target) <=
        (1. + round_off) * compliance(mesh, problem, pair.source))
      continue;
    std::swap(pair.source, pair.target);
    for (double& component : pair.friction.sliding) component = -component;
  }
}

template double mean_poissons_ratio(const mesh::MeshData<2>&, const Problem<2>&,
                                    const ContactPair&);
template double mean_poissons_ratio(const mesh::MeshData<3>&, const Problem<3>&,
                                    const ContactPair&);
template double compliance(const mesh::MeshData<2>&, const Problem<2>&, const std::string&);
template double compliance(const mesh::MeshData<3>&, const Problem<3>&, const std::string&);
template void take_softer_sources(Problem<2>&, const mesh::MeshData<2>&);
template void take_softer_sources(Problem<3>&, const mesh::MeshData<3>&);

}  // namespace geneva::fem
