#include "fem/problem/problem_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace geneva::fem {

namespace {

/// @param what the name stands for
void require_name(const std::vector<std::string>& names, const std::string& name,
                  const ProblemPart part, const std::string& what) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string& candidate : names)
    if (!candidate.empty()) known += (known.empty() ? "'" : ", '") + candidate + "'";
  throw ProblemError(part,
                     fmt::format("{} '{}' is not in the mesh; the mesh has {}", what, name, known));
}

template <int dim>
void check_names(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  for (const Body<dim>& body : problem.bodies)
    require_name(mesh.bodies, body.name, ProblemPart::bodies, "body");
  for (const Support<dim>& support : problem.supports)
    require_name(mesh.surfaces, support.surface, ProblemPart::supports, "surface");
  for (const SurfaceLoad<dim>& load : problem.loads)
    require_name(mesh.surfaces, load.surface, ProblemPart::loads, "surface");
  for (const RigidTie<dim>& tie : problem.ties)
    require_name(mesh.surfaces, tie.surface, ProblemPart::loads, "surface");
  for (const ContactPair& pair : problem.pairs) {
    require_name(mesh.surfaces, pair.source, ProblemPart::pairs, "surface");
    require_name(mesh.surfaces, pair.target, ProblemPart::pairs, "surface");
  }
}

/// @return the one body that a contact surface belongs to
template <int dim>
unsigned int contact_body(const mesh::MeshData<dim>& mesh, const std::string& surface) {
  const auto bodies = mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface));
  if (bodies.empty())
    throw ProblemError(ProblemPart::pairs,
                       fmt::format("surface '{}' is empty: it has no edges", surface));
  if (bodies.size() > 1)
    throw ProblemError(
        ProblemPart::pairs,
        fmt::format("surface '{}' belongs to {} bodies; give each body its own surface", surface,
                    bodies.size()));
  return *bodies.begin();
}

template <int dim>
void check_pairs(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  std::set<std::string> sources;
  for (const ContactPair& pair : problem.pairs) {
    if (pair.source == pair.target)
      throw ProblemError(ProblemPart::pairs,
                         fmt::format("surface '{}' cannot touch itself", pair.source));
    if (contact_body(mesh, pair.source) == contact_body(mesh, pair.target))
      throw ProblemError(
          ProblemPart::pairs,
          fmt::format("surfaces '{}' and '{}' belong to the same body", pair.source, pair.target));
    if (!sources.insert(pair.source).second)
      throw ProblemError(ProblemPart::pairs,
                         fmt::format("surface '{}' is the source of two pairs; make it the "
                                     "target of one of them",
                                     pair.source));
  }
  for (const ContactPair& pair : problem.pairs)
    if (sources.count(pair.target) > 0)
      throw ProblemError(ProblemPart::pairs,
                         fmt::format("the surfaces overlap: '{}' is the source of one pair and "
                                     "the target of another",
                                     pair.target));
}

/// A body that nothing holds and nothing touches can float away.
template <int dim>
void check_held(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  std::set<unsigned int> held;
  const auto add = [&](const std::string& surface) {
    const auto bodies = mesh::bodies_of(mesh, mesh::index_of(mesh.surfaces, surface));
    held.insert(bodies.begin(), bodies.end());
  };
  for (const Support<dim>& support : problem.supports) add(support.surface);
  for (const RigidTie<dim>& tie : problem.ties) add(tie.surface);
  for (const ContactPair& pair : problem.pairs) {
    add(pair.source);
    add(pair.target);
  }
  for (unsigned int body = 0; body < mesh.bodies.size(); ++body)
    if (held.count(body) == 0)
      throw ProblemError(
          ProblemPart::supports,
          fmt::format("body '{}' has neither a support nor a contact surface: nothing holds it",
                      mesh.bodies[body]));
}

}  // namespace

template <int dim>
void order_bodies(Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  for (const Body<dim>& body : problem.bodies)
    require_name(mesh.bodies, body.name, ProblemPart::bodies, "body");
  std::vector<Body<dim>> ordered;
  for (const std::string& name : mesh.bodies) {
    const auto body =
        std::find_if(problem.bodies.begin(), problem.bodies.end(),
                     [&](const Body<dim>& candidate) { return candidate.name == name; });
    if (body == problem.bodies.end())
      throw ProblemError(ProblemPart::bodies,
                         fmt::format("body '{}' of the mesh has no material; name it", name));
    ordered.push_back(*body);
  }
  problem.bodies = ordered;
}

template <int dim>
void check(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh) {
  check_names(problem, mesh);
  check_pairs(problem, mesh);
  check_held(problem, mesh);
}

template void order_bodies(Problem<2>&, const mesh::MeshData<2>&);
template void check(const Problem<2>&, const mesh::MeshData<2>&);
template void order_bodies(Problem<3>&, const mesh::MeshData<3>&);
template void check(const Problem<3>&, const mesh::MeshData<3>&);

}  // namespace geneva::fem
