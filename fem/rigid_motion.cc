#include "fem/rigid_motion.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <vector>

#include "base/errors.h"
#include "fem/problem/moment.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

/// Eigenvalues of the constraints' Gram matrix below this share of the maximum one mean a free
/// motion.
constexpr double free_share = 1e-12;

template <int dim>
bool is_axisymmetric(const Problem<dim>& problem) {
  return dim == 2 && problem.plane == PlaneKind::axisymmetric;
}

/// A displacement component of a boundary node.
template <int dim>
struct Component {
  const BoundaryNode<dim>* node;
  unsigned int direction;
};

/// The rigid motions of all bodies: translations along the axes and rotations about the origin of
/// each; in an axisymmetric model the translation along y alone.
template <int dim>
class RigidMotions {
 public:
  RigidMotions(const Level<dim>& level, const Problem<dim>& problem)
      : per_body_(is_axisymmetric(problem) ? 1
                  : dim == 2               ? 3
                                           : 6),
        size_(static_cast<Eigen::Index>(problem.bodies.size()) * per_body_) {
    for (const BoundaryNode<dim>& node : level.boundary.nodes)
      for (unsigned int direction = 0; direction < dim; ++direction)
        components_.emplace(node.dofs[direction], Component<dim>{&node, direction});
  }

  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Adds factor times the displacement of a dof under each motion to a row.
  void add(const global_dof_index dof, const double factor, Eigen::VectorXd& row) const {
    const Component<dim>& component = components_.at(dof);
    const auto first = static_cast<Eigen::Index>(component.node->body) * per_body_;
    if (per_body_ == 1) {
      if (component.direction == 1) row(first) += factor;
      return;
    }
    row(first + component.direction) += factor;
    dealii::Tensor<1, dim> along;
    along[component.direction] = factor;
    const Moment<dim> rotations = moment_of<dim>(component.node->position, along);
    if constexpr (dim == 2)
      row(first + 2) += rotations;
    else
      for (unsigned int axis = 0; axis < 3; ++axis) row(first + 3 + axis) += rotations[axis];
  }

  /// "body 'pin' can rotate freely", for the motion's largest part.
  [[nodiscard]] std::string describe(const Eigen::VectorXd& motion,
                                     const Problem<dim>& problem) const {
    Eigen::Index largest = 0;
    const double size = motion.cwiseAbs().maxCoeff(&largest);
    const Eigen::Index way = largest % per_body_;
    std::vector<std::string> moving;  // bodies that move together do so by the same amount
    for (Eigen::Index at = way; at < size_; at += per_body_)
      if (std::abs(motion(at)) > 0.5 * size)
        moving.push_back("'" + problem.bodies[static_cast<std::size_t>(at / per_body_)].name + "'");
    const std::vector<const char*> ways =
        dim == 2 ? std::vector{"move along x", "move along y", "rotate"}
                 : std::vector{"move along x",   "move along y",   "move along z",
                               "rotate about x", "rotate about y", "rotate about z"};
    return fmt::format("{} {} can {} freely", moving.size() > 1 ? "bodies" : "body",
                       fmt::join(moving, " and "),
                       ways[per_body_ == 1 ? 1 : static_cast<std::size_t>(way)]);
  }

 private:
  Eigen::Index per_body_;
  Eigen::Index size_;
  std::map<global_dof_index, Component<dim>> components_;
};

/// A contact's relative displacement in a direction under the rigid motions.
template <int dim>
Eigen::VectorXd contact_row(const ContactInterface<dim>& interface, const ContactRow<dim>& contact,
                            const dealii::Tensor<1, dim>& along, const RigidMotions<dim>& motions) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(motions.size());
  for (unsigned int direction = 0; direction < dim; ++direction) {
    motions.add(interface.source.nodes[contact.node].dofs[direction], along[direction], row);
    for (const auto& [node, coupling] : contact.coupling)
      motions.add(interface.target.nodes[node].dofs[direction],
                  -coupling * along[direction] / contact.weight, row);
  }
  return row;
}

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
  for (const ConstraintLine& line : level.held_lines) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(motions.size());
    motions.add(line.dof, 1., row);
    for (const auto& [dof, coefficient] : line.entries) motions.add(dof, -coefficient, row);
    rows.push_back(row);
  }
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
std::string free_motion(const Level<dim>& level, const Problem<dim>& problem,
                        const TakenAsClosed closed) {
  const RigidMotions<dim> motions(level, problem);
  return motions.describe(gram_eigenpairs(level, motions, closed).vectors.col(0), problem);
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
template std::string free_motion(const Level<2>&, const Problem<2>&, TakenAsClosed);
template std::string free_motion(const Level<3>&, const Problem<3>&, TakenAsClosed);
template bool is_held_by_friction(const Level<2>&, const Problem<2>&, const ContactInterface<2>&);
template bool is_held_by_friction(const Level<3>&, const Problem<3>&, const ContactInterface<3>&);
template bool is_held_by_contact(const Level<2>&, const Problem<2>&, const ContactInterface<2>&);
template bool is_held_by_contact(const Level<3>&, const Problem<3>&, const ContactInterface<3>&);
template void check_rigid_motions(const Level<2>&, const Problem<2>&);
template void check_rigid_motions(const Level<3>&, const Problem<3>&);

}  // namespace geneva::fem
