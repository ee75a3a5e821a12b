#include "fem/level.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "fem/conditioning.h"
#include "fem/contact/active_set.h"
#include "fem/contact/conditions.h"
#include "fem/contact/mortar.h"
#include "fem/contact/rounded_edge.h"
#include "fem/contact/surface_in_space.h"
#include "fem/elasticity/elasticity.h"
#include "fem/linear/constraints.h"
#include "fem/problem/source_sides.h"

namespace geneva::fem {

namespace {

template <int dim>
dealii::IndexSet relevant_and_boundary(const dealii::DoFHandler<dim>& dof_handler,
                                       const Boundary<dim>& boundary) {
  dealii::IndexSet ghosts;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, ghosts);
  std::vector<global_dof_index> dofs;
  for (const BoundaryNode<dim>& node : boundary.nodes)
    dofs.insert(dofs.end(), node.dofs.begin(), node.dofs.end());
  std::sort(dofs.begin(), dofs.end());
  ghosts.add_indices(dofs.begin(), dofs.end());
  ghosts.compress();
  return ghosts;
}

/// The node of a surface that is farthest from the other surface: a closed surface is cut open
/// there.
dealii::Point<2> remotest_node(const Surface<2>& surface, const Surface<2>& other) {
  dealii::Point<2> remotest;
  double maximum = -1.;
  for (const SurfaceNode<2>& node : surface.nodes) {
    double nearest = std::numeric_limits<double>::max();
    for (const SurfaceNode<2>& other_node : other.nodes)
      nearest = std::min(nearest, node.position.distance_square(other_node.position));
    if (nearest > maximum * (1. + 1e-9)) {
      maximum = nearest;
      remotest = node.position;
    }
  }
  return remotest;
}

template <int dim>
SurfaceOrigins<dim> choose_origins(const Boundary<dim>& boundary, const mesh::MeshData<dim>& mesh,
                                   const Problem<dim>& problem) {
  SurfaceOrigins<dim> origins{std::vector<dealii::Point<dim>>(problem.pairs.size()),
                              std::vector<dealii::Point<dim>>(problem.pairs.size())};
  if constexpr (dim == 2)
    for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
      const ContactPair& pair = problem.pairs[i];
      const Surface<2> source =
          make_surface(boundary, mesh::index_of(mesh.surfaces, pair.source), {});
      const Surface<2> target =
          make_surface(boundary, mesh::index_of(mesh.surfaces, pair.target), {});
      origins.source[i] = remotest_node(source, target);
      origins.target[i] = remotest_node(target, source);
    }
  return origins;
}

template <int dim>
Surface<dim> surface_from(const Boundary<dim>& boundary, const unsigned int id,
                          [[maybe_unused]] const dealii::Point<dim>& origin) {
  if constexpr (dim == 2)
    return make_surface(boundary, id, origin);
  else
    return make_surface(boundary, id);
}

template <int dim>
double source_share(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                    const ContactPair& pair) {
  const double source = compliance(mesh, problem, pair.source);
  return source / (source + compliance(mesh, problem, pair.target));
}

/// Direction in which the ties' forces push a pair's source to its target; 0 without ties.
template <int dim>
dealii::Tensor<1, dim> approach_of(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                   const ContactPair& pair) {
  const auto body_of = [&](const std::string& surface) {
    return *mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface)).begin();
  };
  dealii::Tensor<1, dim> push;
  for (const RigidTie<dim>& tie : problem.ties) {
    const auto body = body_of(tie.surface);
    const int sign =
        (body == body_of(pair.source) ? 1 : 0) - (body == body_of(pair.target) ? 1 : 0);
    for (unsigned int i = 0; i < dim; ++i) push[i] += sign * tie.force * tie.direction[i];
  }
  return push.norm() > 0. ? push / push.norm() : push;
}

template <int dim>
std::shared_ptr<const ContactLaw<dim>> law_of(const Friction& friction) {
  if (friction.coefficient == 0.) return std::make_shared<const Frictionless<dim>>();
  if (friction.slides()) return std::make_shared<const Sliding<dim>>(friction.coefficient);
  return std::make_shared<const Coulomb<dim>>(friction.coefficient);
}

/// The directions along the surfaces in which the source slides everywhere.
template <int dim>
std::vector<Components<dim>> sliding_of(const std::vector<ContactRow<dim>>& rows,
                                        const Friction& friction) {
  std::vector<Components<dim>> sliding(rows.size());
  if (!friction.slides()) return sliding;
  dealii::Tensor<1, dim> velocity;
  for (unsigned int i = 0; i < dim; ++i) velocity[i] = friction.sliding[i];
  for (std::size_t row = 0; row < rows.size(); ++row) {
    double square = 0.;
    for (std::size_t i = 1; i < dim; ++i) {
      sliding[row][i] = velocity * rows[row].frame.tangents[i - 1];
      square += sliding[row][i] * sliding[row][i];
    }
    if (square > 0.)
      for (double& component : sliding[row]) component /= std::sqrt(square);
  }
  return sliding;
}

template <int dim>
std::vector<ContactInterface<dim>> make_interfaces(const Boundary<dim>& boundary,
                                                   const mesh::MeshData<dim>& mesh,
                                                   const Problem<dim>& problem,
                                                   const SurfaceOrigins<dim>& origins,
                                                   const MPI_Comm communicator) {
  std::vector<ContactInterface<dim>> interfaces;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    ContactInterface<dim> interface;
    interface.source = surface_from(
        boundary, mesh::index_of(mesh.surfaces, problem.pairs[i].source), origins.source[i]);
    interface.target = surface_from(
        boundary, mesh::index_of(mesh.surfaces, problem.pairs[i].target), origins.target[i]);
    interface.source_share = source_share(mesh, problem, problem.pairs[i]);
    interface.rows = mortar_rows(
        interface.source, interface.target,
        MortarData<dim>{
            [&](const dealii::Point<dim>& point) { return out_of_plane_measure(problem, point); },
            interface.source_share, problem.pairs[i].clearance, communicator,
            has_rounded_edge(interface.target) && !has_rounded_edge(interface.source)});
    interface.approach = approach_of(mesh, problem, problem.pairs[i]);
    interface.law = law_of<dim>(problem.pairs[i].friction);
    interface.sliding = sliding_of(interface.rows, problem.pairs[i].friction);
    interface.status = first_touch(interface);
    interfaces.push_back(std::move(interface));
  }
  return interfaces;
}

/// Unknowns of the contacts' nodes and of supports and ties.
template <int dim>
std::set<global_dof_index> forced_dofs(const Level<dim>& level) {
  std::set<global_dof_index> dofs = level.held;
  for (const ContactInterface<dim>& interface : level.interfaces)
    for (const Surface<dim>* const surface : {&interface.source, &interface.target})
      for (const SurfaceNode<dim>& node : surface->nodes)
        dofs.insert(node.dofs.begin(), node.dofs.end());
  return dofs;
}

template <int dim>
void add_held_lines(Level<dim>& level, const mesh::MeshData<dim>& mesh,
                    const Problem<dim>& problem) {
  level.tie_forces.clear();
  level.held_lines = support_lines(level.boundary, problem.supports, mesh.surfaces);
  for (const RigidTie<dim>& tie : problem.ties) {
    const TieLines lines = tie_lines(level.boundary, tie, mesh.surfaces);
    level.held_lines.insert(level.held_lines.end(), lines.lines.begin(), lines.lines.end());
    level.tie_forces.push_back({lines.master, lines.master_force});
    level.held.insert(lines.master);
  }
  for (const ConstraintLine& line : level.held_lines) level.held.insert(line.dof);
}

template <int dim>
std::vector<ConstraintLine> lasting_lines(const Level<dim>& level) {
  std::vector<ConstraintLine> lines = level.hanging_lines;
  lines.insert(lines.end(), level.held_lines.begin(), level.held_lines.end());
  return lines;
}

}  // namespace

template <int dim>
Level<dim> make_level(const dealii::DoFHandler<dim>& dof_handler, const mesh::MeshData<dim>& mesh,
                      const Problem<dim>& scaled_problem, const Scales& scales,
                      std::optional<SurfaceOrigins<dim>>& origins) {
  Level<dim> level;
  level.owned = dof_handler.locally_owned_dofs();
  level.boundary = gather_boundary(dof_handler, mesh.circles, scales.length);
  level.ghosts = relevant_and_boundary(dof_handler, level.boundary);
  if (!origins) origins = choose_origins(level.boundary, mesh, scaled_problem);
  level.interfaces = make_interfaces(level.boundary, mesh, scaled_problem, *origins,
                                     dof_handler.get_communicator());
  level.is_factorised = is_factorised(scaled_problem);
  level.hanging_nodes = hanging_nodes(dof_handler, level.ghosts);
  level.hanging_lines = hanging_lines(dof_handler, level.hanging_nodes, level.boundary);
  level.hanging = make_constraints(level.hanging_nodes, level.hanging_lines);
  level.holds_by_friction.assign(level.interfaces.size(), false);
  level.holds_by_contact.assign(level.interfaces.size(), false);
  set_load(level, dof_handler, mesh, scaled_problem);
  return level;
}

template <int dim>
void set_load(Level<dim>& level, const dealii::DoFHandler<dim>& dof_handler,
              const mesh::MeshData<dim>& mesh, const Problem<dim>& scaled_problem) {
  level.cells = cell_systems(dof_handler, scaled_problem, mesh.surfaces);
  add_held_lines(level, mesh, scaled_problem);
  level.forced = forced_unknowns(forced_dofs(level), level.cells, level.hanging);
}

template <int dim>
dealii::AffineConstraints<double> lasting_constraints(const Level<dim>& level) {
  return make_constraints(level.hanging_nodes, lasting_lines(level));
}

template <int dim>
SystemConstraints constraints(const Level<dim>& level) {
  std::vector<ConstraintLine> lines = lasting_lines(level);
  std::vector<ConstraintLine> virtual_lines = lines;
  std::set<global_dof_index> held = level.held;
  bool are_equal = true;
  for (const ContactInterface<dim>& interface : level.interfaces) {
    const ContactLines contact = contact_lines(interface, held);
    lines.insert(lines.end(), contact.displacement.begin(), contact.displacement.end());
    virtual_lines.insert(virtual_lines.end(), contact.virtual_displacement.begin(),
                         contact.virtual_displacement.end());
    are_equal &= contact.are_equal;
  }
  SystemConstraints result{make_constraints(level.hanging_nodes, lines)};
  if (!are_equal)
    result.virtual_displacement = make_constraints(level.hanging_nodes, virtual_lines);
  return result;
}

template Level<2> make_level(const dealii::DoFHandler<2>&, const mesh::MeshData<2>&,
                             const Problem<2>&, const Scales&, std::optional<SurfaceOrigins<2>>&);
template Level<3> make_level(const dealii::DoFHandler<3>&, const mesh::MeshData<3>&,
                             const Problem<3>&, const Scales&, std::optional<SurfaceOrigins<3>>&);
template void set_load(Level<2>&, const dealii::DoFHandler<2>&, const mesh::MeshData<2>&,
                       const Problem<2>&);
template void set_load(Level<3>&, const dealii::DoFHandler<3>&, const mesh::MeshData<3>&,
                       const Problem<3>&);
template dealii::AffineConstraints<double> lasting_constraints(const Level<2>&);
template dealii::AffineConstraints<double> lasting_constraints(const Level<3>&);
template SystemConstraints constraints(const Level<2>&);
template SystemConstraints constraints(const Level<3>&);

}  // namespace geneva::fem
