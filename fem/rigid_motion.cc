#include "fem/rigid_motion.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <map>
#include <stdexcept>

namespace geneva::fem {

namespace {

/// Eigenvalues of the constraints' Gram matrix below this share of the greatest one mean a free
/// motion.
constexpr double free_motion = 1e-12;

/// A displacement component of a boundary node.
struct Component {
  const BoundaryNode<2>* node;
  unsigned int direction;
};

/// The rigid motions of all bodies: translations along x and y and the rotation about the origin of
/// each; in an axisymmetric model the translation along y alone.
class RigidMotions {
 public:
  RigidMotions(const Level<2>& level, const Problem<2>& problem)
      : per_body_(problem.plane == PlaneKind::axisymmetric ? 1 : 3),
        size_(static_cast<Eigen::Index>(problem.bodies.size()) * per_body_) {
    for (const BoundaryNode<2>& node : level.boundary.nodes)
      for (unsigned int direction = 0; direction < 2; ++direction)
        components_.emplace(node.dofs[direction], Component{&node, direction});
  }

  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Adds factor times the displacement of a dof under each motion to a row.
  void add(const global_dof_index dof, const double factor, Eigen::VectorXd& row) const {
    const Component& component = components_.at(dof);
    const auto first = static_cast<Eigen::Index>(component.node->body) * per_body_;
    if (per_body_ == 1) {
      if (component.direction == 1) row(first) += factor;
      return;
    }
    row(first + component.direction) += factor;
    row(first + 2) += component.direction == 0 ? -factor * component.node->position[1]
                                               : factor * component.node->position[0];
  }

  /// "body 'pin' can rotate", for the motion's largest part.
  [[nodiscard]] std::string describe(const Eigen::VectorXd& motion,
                                     const Problem<2>& problem) const {
    Eigen::Index largest = 0;
    motion.cwiseAbs().maxCoeff(&largest);
    const std::string& body = problem.bodies[static_cast<std::size_t>(largest / per_body_)].name;
    constexpr std::array<const char*, 3> ways{"move along x", "move along y", "rotate"};
    const auto way = per_body_ == 1 ? 1 : static_cast<std::size_t>(largest % per_body_);
    return fmt::format("body '{}' can {} freely", body, ways[way]);
  }

 private:
  Eigen::Index per_body_;
  Eigen::Index size_;
  std::map<global_dof_index, Component> components_;
};

/// The constraints as seen by the rigid motions: one row for every line and every contact row,
/// scaled to size 1.
std::vector<Eigen::VectorXd> constraint_rows(const Level<2>& level, const RigidMotions& motions) {
  std::vector<Eigen::VectorXd> rows;
  for (const ConstraintLine& line : level.held_lines) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(motions.size());
    motions.add(line.dof, 1., row);
    for (const auto& [dof, coefficient] : line.entries) motions.add(dof, -coefficient, row);
    rows.push_back(row);
  }
  for (const ContactInterface<2>& interface : level.interfaces)
    for (const MortarRow<2>& contact : interface.rows) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(motions.size());
      for (unsigned int direction = 0; direction < 2; ++direction) {
        motions.add(interface.source.nodes[contact.node].dofs[direction], contact.normal[direction],
                    row);
        for (const auto& [node, coupling] : contact.coupling)
          motions.add(interface.target.nodes[node].dofs[direction],
                      -coupling[direction] / contact.weight, row);
      }
      rows.push_back(row);
    }
  return rows;
}

}  // namespace

void check_rigid_motions(const Level<2>& level, const Problem<2>& problem) {
  const RigidMotions motions(level, problem);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(motions.size(), motions.size());
  for (const Eigen::VectorXd& row : constraint_rows(level, motions)) gram += row * row.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  if (eigen.eigenvalues()(0) > free_motion * eigen.eigenvalues().maxCoeff()) return;
  throw std::invalid_argument(motions.describe(eigen.eigenvectors().col(0), problem) +
                              ": supports, rigid loads and contact pairs do not hold it; add a "
                              "support, for example 'NAME: x' on a plane of "
                              "symmetry");
}

}  // namespace geneva::fem
