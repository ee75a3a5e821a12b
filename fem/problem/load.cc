#include "fem/problem/load.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace geneva::fem {

namespace {

/// Calls scale(part, share) for every part.
template <typename Part, typename Scale>
void scale_all(std::vector<Part>& parts, const std::vector<double>& shares, const Scale& scale) {
  if (shares.empty()) return;
  if (shares.size() != parts.size())
    throw std::invalid_argument("a load does not fit its problem: it has other numbers of parts");
  for (std::size_t i = 0; i < parts.size(); ++i) scale(parts[i], shares[i]);
}

template <std::size_t dim>
void multiply(std::array<double, dim>& components, const double share) {
  for (double& component : components) component *= share;
}

}  // namespace

bool operator==(const Load& one, const Load& other) {
  const auto parts = [](const Load& load) {
    return std::tie(load.body_forces, load.surface_loads, load.ties, load.supports);
  };
  return parts(one) == parts(other);
}

template <int dim>
Problem<dim> at_instant(const Problem<dim>& problem, const Load& load) {
  Problem<dim> result = problem;
  scale_all(result.bodies, load.body_forces, [](Body<dim>& body, const double share) {
    multiply(body.force.uniform, share);
    multiply(body.force.acceleration, share);
    body.force.spin *= std::sqrt(std::max(0., share));
    body.force.rotation.inertia *= share;
  });
  scale_all(result.loads, load.surface_loads, [](SurfaceLoad<dim>& surface, const double share) {
    surface.pressure *= share;
    multiply(surface.traction, share);
  });
  scale_all(result.ties, load.ties,
            [](RigidTie<dim>& tie, const double share) { tie.force *= share; });
  scale_all(result.supports, load.supports, [](Support<dim>& support, const double share) {
    for (auto& component : support.displacement)
      if (component) *component *= share;
  });
  return result;
}

template Problem<2> at_instant(const Problem<2>&, const Load&);
template Problem<3> at_instant(const Problem<3>&, const Load&);

}  // namespace geneva::fem
