#include "fem/rigid_balance.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <vector>

#include "fem/rigid_modes.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

using Columns = std::vector<Eigen::VectorXd>;

Eigen::MatrixXd matrix_of(const Columns& columns, const Eigen::Index rows) {
  Eigen::MatrixXd matrix(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = columns[i];
  return matrix;
}

/// The motions that supports and ties allow, as orthonormal columns.
template <int dim>
Eigen::MatrixXd allowed_motions(const Level<dim>& level, const RigidMotions<dim>& motions) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(motions.size(), motions.size());
  for (const ConstraintLine& line : level.held_lines) {
    const Eigen::VectorXd row = held_row(line, motions);
    gram += row * row.transpose();
  }
  const mesh::Eigenpairs eigen = mesh::symmetric_eigenpairs(gram);
  Eigen::Index n = 0;
  while (n < eigen.values.size() && eigen.values(n) <= free_share * eigen.values.maxCoeff()) ++n;
  return eigen.vectors.leftCols(n);
}

/// Work of all loads under each motion.
template <int dim>
Eigen::VectorXd work_of_loads(const dealii::DoFHandler<dim>& dof_handler, const Level<dim>& level,
                              const RigidMotions<dim>& motions) {
  Eigen::VectorXd work = Eigen::VectorXd::Zero(motions.size());
  std::size_t index = 0;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const dealii::Vector<double> load = level.cells.load(index++);
    for (unsigned int i = 0; i < load.size(); ++i) {
      const auto [component, vertex] = dof_handler.get_fe().system_to_component_index(i);
      dealii::Tensor<1, dim> force;
      force[component] = load[i];
      motions.add(cell->material_id(), cell->vertex(vertex), force, work);
    }
  }
  for (Eigen::Index i = 0; i < work.size(); ++i)
    work(i) = dealii::Utilities::MPI::sum(work(i), dof_handler.get_communicator());
  for (const NodalForce& force : level.tie_forces) motions.add(force.dof, force.value, work);
  return work;
}

/// Directions of the forces that bound what a node can exert on the source; in 3-D those of a
/// pyramid around the cone of friction.
template <int dim>
std::vector<dealii::Tensor<1, dim>> bounding_forces(const ContactFrame<dim>& frame,
                                                    const double friction) {
  constexpr unsigned int n_sides = 16;
  const double pi = std::acos(-1.);
  if (friction == 0.) return {frame.normal};
  std::vector<dealii::Tensor<1, dim>> forces;
  if constexpr (dim == 2) {
    for (const double side : {-friction, friction})
      forces.push_back(frame.normal + side * frame.tangents[0]);
  } else {
    const double around = friction / std::cos(pi / n_sides);
    for (unsigned int i = 0; i < n_sides; ++i) {
      const double angle = 2. * pi * i / n_sides;
      forces.push_back(frame.normal + around * (std::cos(angle) * frame.tangents[0] +
                                                std::sin(angle) * frame.tangents[1]));
    }
  }
  return forces;
}

template <int dim>
Columns works_of_contacts(const Level<dim>& level, const Problem<dim>& problem,
                          const RigidMotions<dim>& motions) {
  Columns works;
  for (std::size_t i = 0; i < level.interfaces.size(); ++i)
    for (const ContactRow<dim>& row : level.interfaces[i].rows)
      for (const auto& force : bounding_forces(row.frame, problem.pairs[i].friction.coefficient))
        works.push_back(contact_row(level.interfaces[i], row, force, motions));
  return works;
}

}  // namespace

template <int dim>
std::optional<UnresistedMotion> unresisted_motion(const dealii::DoFHandler<dim>& dof_handler,
                                                  const Level<dim>& level,
                                                  const Problem<dim>& problem) {
  constexpr double balanced = 1e-3;
  const RigidMotions<dim> motions(level, problem);
  const Eigen::MatrixXd allowed = allowed_motions(level, motions);
  const Eigen::VectorXd load = allowed.transpose() * work_of_loads(dof_handler, level, motions);
  const Eigen::MatrixXd contacts =
      allowed.transpose() * matrix_of(works_of_contacts(level, problem, motions), motions.size());
  const Eigen::VectorXd open =
      load + contacts * mesh::nonnegative_least_squares(contacts, Eigen::VectorXd(-load));
  if (open.norm() <= balanced * load.norm()) return std::nullopt;
  const Eigen::VectorXd motion = motions.as_displacements(allowed * open);
  return UnresistedMotion{motions.describe(motion, problem), motions.is_rotation(motion)};
}

template std::optional<UnresistedMotion> unresisted_motion(const dealii::DoFHandler<2>&,
                                                           const Level<2>&, const Problem<2>&);
template std::optional<UnresistedMotion> unresisted_motion(const dealii::DoFHandler<3>&,
                                                           const Level<3>&, const Problem<3>&);

}  // namespace geneva::fem
