#pragma once

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace geneva::fem {

/// The nodes of a stiffness matrix that this rank knows: its own ones in the order of their
/// unknowns, then those of other ranks that they are coupled to.
template <int dim>
class CoupledNodes {
 public:
  /// @param matrix of trilinear or bilinear displacements; must outlive this
  CoupledNodes(const dealii::TrilinosWrappers::SparseMatrix& matrix,
               const dealii::DoFHandler<dim>& dof_handler);

  [[nodiscard]] std::size_t n_own() const { return neighbours_.size(); }
  [[nodiscard]] std::size_t n_all() const { return positions_.size(); }
  [[nodiscard]] const dealii::Point<dim>& position(const std::size_t node) const {
    return positions_[node];
  }
  [[nodiscard]] unsigned int body(const std::size_t node) const { return bodies_[node]; }
  /// Other nodes that an own node is coupled to, of any body and rank.
  [[nodiscard]] const std::vector<std::size_t>& neighbours(const std::size_t own_node) const {
    return neighbours_[own_node];
  }

  /// One entry of the matrix.
  struct Entry {
    std::size_t node;        ///< of the column
    unsigned int component;  ///< of the column
    double value;
  };
  /// Calls visit(entry) for the entries of a row.
  template <typename Visit>
  void visit_row(const std::size_t own_node, const unsigned int component,
                 const Visit& visit) const {
    int count = 0;
    double* values = nullptr;
    int* columns = nullptr;
    matrix_.ExtractMyRowView(static_cast<int>(own_node * dim + component), count, values, columns);
    for (int i = 0; i < count; ++i) {
      const auto column = static_cast<std::size_t>(columns[i]);
      visit(Entry{node_of_column_[column], component_of_column_[column], values[i]});
    }
  }

  /// Values of all nodes from those of the ranks that own them.
  [[nodiscard]] std::vector<double> on_all_nodes(const std::vector<double>& of_own_nodes) const;
  /// An unknown of a node of another rank.
  struct OtherUnknown {
    int number;  ///< among the unknowns of all ranks
    std::size_t node;
    unsigned int component;
  };
  [[nodiscard]] const std::vector<OtherUnknown>& unknowns_of_others() const { return others_; }

 private:
  void number_columns();
  void find_neighbours();

  const Epetra_CrsMatrix& matrix_;
  std::vector<std::size_t> node_of_column_;
  std::vector<unsigned int> component_of_column_;
  std::vector<OtherUnknown> others_;
  std::vector<dealii::Point<dim>> positions_;
  std::vector<unsigned int> bodies_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

}  // namespace geneva::fem
