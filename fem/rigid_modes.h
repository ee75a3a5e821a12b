#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fem/level.h"
#include "fem/problem/moment.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// Eigenvalues of the constraints' Gram matrix below this share of the maximum one mean a free
/// motion.
constexpr double free_share = 1e-12;

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
      : per_body_(dim == 2 && problem.plane == PlaneKind::axisymmetric ? 1
                  : dim == 2                                           ? 3
                                                                       : 6),
        size_(static_cast<Eigen::Index>(problem.bodies.size()) * per_body_) {
    const auto most = std::numeric_limits<double>::max();
    Box box;
    for (unsigned int i = 0; i < dim; ++i) {
      box.first[i] = most;
      box.second[i] = -most;
    }
    boxes_.assign(problem.bodies.size(), box);
    for (const BoundaryNode<dim>& node : level.boundary.nodes)
      for (unsigned int i = 0; i < dim; ++i) {
        auto& [low, high] = boxes_[node.body];
        low[i] = std::min(low[i], node.position[i]);
        high[i] = std::max(high[i], node.position[i]);
      }
    for (const BoundaryNode<dim>& node : level.boundary.nodes)
      for (unsigned int direction = 0; direction < dim; ++direction)
        components_.emplace(node.dofs[direction], Component<dim>{&node, direction});
  }

  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Adds factor times the displacement of a dof under each motion to a row.
  void add(const global_dof_index dof, const double factor, Eigen::VectorXd& row) const {
    const Component<dim>& component = components_.at(dof);
    dealii::Tensor<1, dim> along;
    along[component.direction] = factor;
    add(component.node->body, component.node->position, along, row);
  }

  /// Adds the displacement of a body's point under each motion, times a vector, to a row.
  void add(const unsigned int body, const dealii::Point<dim>& place,
           const dealii::Tensor<1, dim>& along, Eigen::VectorXd& row) const {
    const auto first = static_cast<Eigen::Index>(body) * per_body_;
    if (per_body_ == 1) {
      row(first) += along[1];
      return;
    }
    for (unsigned int direction = 0; direction < dim; ++direction)
      row(first + direction) += along[direction];
    const Moment<dim> rotations = moment_of<dim>(place, along);
    if constexpr (dim == 2)
      row(first + 2) += rotations;
    else
      for (unsigned int axis = 0; axis < 3; ++axis) row(first + 3 + axis) += rotations[axis];
  }

  /// A motion as displacements: of each body's middle, and by its rotations of what is a diagonal
  /// of the body away. So a body that tips over an edge rotates more than it moves.
  [[nodiscard]] Eigen::VectorXd as_displacements(const Eigen::VectorXd& motion) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
    for (std::size_t body = 0; body < boxes_.size(); ++body) {
      const auto& [low, high] = boxes_[body];
      const dealii::Point<dim> middle(0.5 * (low + high));
      const auto first = static_cast<Eigen::Index>(body) * per_body_;
      for (Eigen::Index way = 0; way < per_body_; ++way) {
        if (per_body_ > 1 && way >= dim) {
          result(first + way) = motion(first + way) * (high - low).norm();
          continue;
        }
        Eigen::VectorXd row = Eigen::VectorXd::Zero(size_);
        dealii::Tensor<1, dim> along;
        along[per_body_ == 1 ? 1 : static_cast<unsigned int>(way)] = 1.;
        add(static_cast<unsigned int>(body), middle, along, row);
        result(first + way) = row.dot(motion);
      }
    }
    return result;
  }

  /// Whether a motion's largest part is a rotation.
  [[nodiscard]] bool is_rotation(const Eigen::VectorXd& motion) const {
    Eigen::Index largest = 0;
    motion.cwiseAbs().maxCoeff(&largest);
    return largest % per_body_ >= dim;
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
  using Box = std::pair<dealii::Tensor<1, dim>, dealii::Tensor<1, dim>>;  ///< low, high

  Eigen::Index per_body_;
  Eigen::Index size_;
  std::vector<Box> boxes_;  ///< of the bodies
  std::map<global_dof_index, Component<dim>> components_;
};

/// What a line holds to 0 under the rigid motions.
template <int dim>
Eigen::VectorXd held_row(const ConstraintLine& line, const RigidMotions<dim>& motions) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(motions.size());
  motions.add(line.dof, 1., row);
  for (const auto& [dof, coefficient] : line.entries) motions.add(dof, -coefficient, row);
  return row;
}

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

}  // namespace geneva::fem
