#pragma once

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>

#include <vector>

#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// The nodes of a stiffness matrix that this rank knows: its own ones in the order of their
/// unknowns, then those of other ranks that they are coupled to.
template <int dim>
class CoupledNodes {
 public:
  /// @param matrix of trilinear or bilinear displacements; must outlive this
  CoupledNodes(const SymmetricMatrix<dim>& matrix, const dealii::DoFHandler<dim>& dof_handler);

  [[nodiscard]] std::size_t n_own() const { return neighbours_.size(); }
  [[nodiscard]] std::size_t n_all() const { return positions_.size(); }
  [[nodiscard]] const dealii::Point<dim>& position(const std::size_t node) const {
    return positions_[node];
  }
  [[nodiscard]] const std::vector<dealii::Point<dim>>& positions() const { return positions_; }
  [[nodiscard]] unsigned int body(const std::size_t node) const { return bodies_[node]; }
  /// Other nodes that an own node is coupled to, of any body and rank.
  [[nodiscard]] const std::vector<std::size_t>& neighbours(const std::size_t own_node) const {
    return neighbours_[own_node];
  }

  [[nodiscard]] const SymmetricMatrix<dim>& matrix() const { return matrix_; }
  /// Values of all nodes from those of the ranks that own them.
  [[nodiscard]] std::vector<double> on_all_nodes(const std::vector<double>& of_own_nodes) const {
    return matrix_.pattern().on_all_nodes(of_own_nodes);
  }

 private:
  void find_neighbours();

  const SymmetricMatrix<dim>& matrix_;
  std::vector<dealii::Point<dim>> positions_;
  std::vector<unsigned int> bodies_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

}  // namespace geneva::fem
