#include "fem/contact_problem.h"

#include <algorithm>

#include "fem/accuracy_loop.h"
#include "fem/conditioning.h"
#include "fem/problem/problem_check.h"

namespace geneva::fem {

namespace {

/// A coarse mesh is solved whatever the limit of unknowns says, unless that takes more than
/// seconds.
template <int dim>
void check_size(const mesh::MeshData<dim>& mesh, const Settings& settings) {
  constexpr std::size_t small = 100'000;
  const std::size_t unknowns = dim * mesh.vertices.size();
  if (unknowns > std::max<std::size_t>(small, settings.max_dofs))
    throw NotConverged({Outcome::coarse_dof_limit, static_cast<double>(unknowns),
                        static_cast<double>(settings.max_dofs), unknowns});
}

}  // namespace

template <int dim>
Solution<dim> solve_contact(const MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                            const Problem<dim>& problem, const Settings& settings,
                            const Progress<dim>& progress,
                            const std::optional<Checkpoint<dim>>& start) {
  check_size(mesh, settings);
  check(problem, mesh);
  check_stiffness_ratio(problem, mesh);
  return AccuracyLoop<dim>(communicator, mesh, problem, settings, progress).run(start);
}

template Solution<2> solve_contact(MPI_Comm, const mesh::MeshData<2>&, const Problem<2>&,
                                   const Settings&, const Progress<2>&,
                                   const std::optional<Checkpoint<2>>&);
template Solution<3> solve_contact(MPI_Comm, const mesh::MeshData<3>&, const Problem<3>&,
                                   const Settings&, const Progress<3>&,
                                   const std::optional<Checkpoint<3>>&);

}  // namespace geneva::fem
