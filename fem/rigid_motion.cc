#include "fem/rigid_motion.h"

#include <Eigen/Core>
#include <vector>

#include "base/errors.h"
#include "fem/rigid_modes.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

/// The constraints as seen by the rigid motions: one row for every line and every contact row,
/// scaled to size 1.
/// @param sliding the one without friction; may be null
/// @param open the one that is not closed at all; may be null
template <int dim>
std::vector<Eigen::VectorXd> constraint_rows(const Level<dim>& level,
                                             const RigidMotions<dim>& motions,
                                             const TakenAsClosed closed,
                                             const ContactInterface<dim>* const sliding,
                                             const ContactInterface<dim>* const open) {
  std::vector<Eigen::VectorXd> rows;
  for (const ConstraintLine& line : level.held_lines) rows.push_back(held_row(line, motions));
  for (const ContactInterface<dim>& interface : level.interfaces) {
    if (&interface == open) continue;
    for (std::size_t i = 0; i < interface.rows.size(); ++i) {
      if (closed == TakenAsClosed::active_nodes && !is_closed(interface.status[i])) continue;
      const ContactFrame<dim>& frame = interface.rows[i].frame;
      rows.push_back(contact_row(interface, interface.rows[i], frame.normal, motions));
      const bool sticks = closed == TakenAsClosed::active_nodes
                              ? interface.status[i] == NodeStatus::stick
                              : closed == TakenAsClosed::all_nodes && interface.may_stick();
      if (!sticks || &interface == sliding) continue;
      for (const dealii::Tensor<1, dim>& tangent : frame.tangents)
        rows.push_back(contact_row(interface, interface.rows[i], tangent, motions));
    }
  }
  return rows;
}

template <int dim>
mesh::Eigenpairs gram_eigenpairs(const Level<dim>& level, const RigidMotions<dim>& motions,
                                 const TakenAsClosed closed,
                                 const ContactInterface<dim>* const sliding = nullptr,
                                 const ContactInterface<dim>* const open = nullptr) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(motions.size(), motions.size());
  for (const Eigen::VectorXd& row : constraint_rows(level, motions, closed, sliding, open))
    gram += row * row.transpose();
  return mesh::symmetric_eigenpairs(gram);
}

bool is_free(const mesh::Eigenpairs& eigen) {
  return eigen.values(0) <= free_share * eigen.values.maxCoeff();
}

}  // namespace

template <int dim>
bool has_free_motion(const Level<dim>& level, const Problem<dim>& problem,
                     const TakenAsClosed closed) {
  return is_free(gram_eigenpairs(level, RigidMotions<dim>(level, problem), closed));
}

template <int dim>
bool is_held_by_friction(const Level<dim>& level, const Problem<dim>& problem,
                         const ContactInterface<dim>& interface) {
  return is_free(gram_eigenpairs(level, RigidMotions<dim>(level, problem), TakenAsClosed::all_nodes,
                                 &interface));
}

template <int dim>
bool is_held_by_contact(const Level<dim>& level, const Problem<dim>& problem,
                        const ContactInterface<dim>& interface) {
  const ContactInterface<dim>* const none = nullptr;
  return is_free(gram_eigenpairs(level, RigidMotions<dim>(level, problem), TakenAsClosed::all_nodes,
                                 none, &interface));
}

template <int dim>
void check_rigid_motions(const Level<dim>& level, const Problem<dim>& problem) {
  const RigidMotions<dim> motions(level, problem);
  const mesh::Eigenpairs eigen = gram_eigenpairs(level, motions, TakenAsClosed::all_nodes);
  if (!is_free(eigen)) return;
  throw base::InputError(motions.describe(eigen.vectors.col(0), problem) +
                         ": supports, rigid loads and contact pairs do not hold it; add a "
                         "support, for example 'NAME: x' on a plane of "
                         "symmetry");
}

template bool has_free_motion(const Level<2>&, const Problem<2>&, TakenAsClosed);
template bool has_free_motion(const Level<3>&, const Problem<3>&, TakenAsClosed);
template bool is_held_by_friction(const Level<2>&, const Problem<2>&, const ContactInterface<2>&);
template bool is_held_by_friction(const Level<3>&, const Problem<3>&, const ContactInterface<3>&);
template bool is_held_by_contact(const Level<2>&, const Problem<2>&, const ContactInterface<2>&);
template bool is_held_by_contact(const Level<3>&, const Problem<3>&, const ContactInterface<3>&);
template void check_rigid_motions(const Level<2>&, const Problem<2>&);
template void check_rigid_motions(const Level<3>&, const Problem<3>&);

}  // namespace geneva::fem
