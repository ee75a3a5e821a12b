#include "fem/boundary_tractions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace geneva::fem {

namespace {

/// Vertices of a plane agree to this share of the mesh's size.
constexpr double place_round_off = 1e-9;

/// Whether every face of a surface has one coordinate along an axis.
template <int dim>
bool is_normal_to(const unsigned int axis, const mesh::MeshData<dim>& mesh,
                  const unsigned int surface, const double size) {
  return std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const mesh::Face<dim>& face) {
    const double place = mesh.vertices[face.vertices.front()][axis];
    return face.surface != surface ||
           std::all_of(face.vertices.begin(), face.vertices.end(), [&](const unsigned int vertex) {
             return std::abs(mesh.vertices[vertex][axis] - place) <= place_round_off * size;
           });
  });
}

/// The component that a support holds, if it holds one only and that at rest.
template <int dim>
std::optional<unsigned int> only_held_component(const Support<dim>& support) {
  std::optional<unsigned int> held;
  for (unsigned int i = 0; i < dim; ++i) {
    if (!support.displacement[i]) continue;
    if (held || *support.displacement[i] != 0.) return std::nullopt;
    held = i;
  }
  return held;
}

/// Whether the body of a surface has a uniform force along an axis: then nothing is mirrored there.
template <int dim>
bool is_pulled_along(const unsigned int axis, const mesh::MeshData<dim>& mesh,
                     const Problem<dim>& problem, const unsigned int surface) {
  const std::set<unsigned int> bodies = mesh::bodies_of(mesh, surface);
  return std::any_of(bodies.begin(), bodies.end(), [&](const unsigned int i) {
    const Body<dim>& body = problem.bodies[i];
    return body.force.uniform[axis] + body.density * body.force.acceleration[axis] != 0.;
  });
}

template <int dim>
SurfaceTraction<dim> of_support(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                const Support<dim>& support, const double size) {
  const unsigned int surface = mesh::index_of(mesh.surfaces, support.surface);
  const auto axis = only_held_component(support);
  if (axis && is_normal_to(*axis, mesh, surface, size) &&
      !is_pulled_along(*axis, mesh, problem, surface))
    return {TractionKind::mirrored, *axis, 0., {}};
  return {TractionKind::held, 0, 0., {}};
}

}  // namespace

template <int dim>
BoundaryTractions<dim> boundary_tractions(const mesh::MeshData<dim>& mesh,
                                          const Problem<dim>& problem, const Scales& scales,
                                          const std::vector<ContactResult<dim>>& contacts) {
  BoundaryTractions<dim> result;
  result.surfaces.resize(mesh.surfaces.size());
  const auto of = [&](const std::string& name) -> SurfaceTraction<dim>& {
    return result.surfaces[mesh::index_of(mesh.surfaces, name)];
  };
  for (const SurfaceLoad<dim>& load : problem.loads) {
    of(load.surface).pressure += load.pressure;
    for (unsigned int i = 0; i < dim; ++i) of(load.surface).traction[i] += load.traction[i];
  }
  for (const ContactPair& pair : problem.pairs)
    of(pair.source).kind = of(pair.target).kind = TractionKind::contact;
  for (const Support<dim>& support : problem.supports) {
    SurfaceTraction<dim>& surface = of(support.surface);
    const bool is_held_twice =
        surface.kind == TractionKind::held || surface.kind == TractionKind::mirrored;
    const SurfaceTraction<dim> held = of_support(mesh, problem, support, scales.length);
    surface.kind = is_held_twice ? TractionKind::held : held.kind;
    surface.axis = held.axis;
  }
  for (const RigidTie<dim>& tie : problem.ties) of(tie.surface).kind = TractionKind::held;
  for (mesh::Circle circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate /= scales.length;
    circle.radius /= scales.length;
    circle.ring_radius /= scales.length;
    result.circles.push_back(circle);
  }
  for (const ContactResult<dim>& contact : contacts)
    for (const ContactNode<dim>& node : contact.nodes) {
      if (!is_closed(node.status)) continue;
      result.in_contact.emplace_back();
      for (unsigned int i = 0; i < dim; ++i)
        result.in_contact.back()[i] = node.position[i] / scales.length;
    }
  return result;
}

template <int dim>
BoundaryTractions<dim> boundary_tractions(const Solution<dim>& solution) {
  BoundaryTractions<dim> result =
      boundary_tractions(solution.mesh, solution.problem, solution.scales, solution.contacts);
  result.at_held = solution.held_tractions;
  return result;
}

template BoundaryTractions<2> boundary_tractions(const Solution<2>&);
template BoundaryTractions<3> boundary_tractions(const Solution<3>&);
template BoundaryTractions<2> boundary_tractions(const mesh::MeshData<2>&, const Problem<2>&,
                                                 const Scales&,
                                                 const std::vector<ContactResult<2>>&);
template BoundaryTractions<3> boundary_tractions(const mesh::MeshData<3>&, const Problem<3>&,
                                                 const Scales&,
                                                 const std::vector<ContactResult<3>>&);

}  // namespace geneva::fem
