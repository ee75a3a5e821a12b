#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "fem/problem/problem.h"

namespace geneva::fem {

/// Stiffness matrix and load vector of one cell, before any constraint.
struct CellSystem {
  dealii::FullMatrix<double> stiffness;
  dealii::Vector<double> load;
  std::vector<dealii::types::global_dof_index> dofs;
};

/// The systems of this rank's cells, each integrated when it is asked for: together they would take
/// about as much memory as the rest of an analysis.
class CellSystems {
 public:
  using Dofs = std::vector<dealii::types::global_dof_index>;

  CellSystems() = default;
  /// @param dofs of each cell
  /// @param stiffness of a cell by its index
  /// @param load of a cell by its index
  CellSystems(std::vector<Dofs> dofs,
              std::function<dealii::FullMatrix<double>(std::size_t)> stiffness,
              std::function<dealii::Vector<double>(std::size_t)> load);

  [[nodiscard]] std::size_t size() const { return dofs_.size(); }
  [[nodiscard]] const Dofs& dofs(const std::size_t index) const { return dofs_[index]; }
  [[nodiscard]] dealii::FullMatrix<double> stiffness(const std::size_t index) const {
    return stiffness_(index);
  }
  [[nodiscard]] dealii::Vector<double> load(const std::size_t index) const { return load_(index); }
  [[nodiscard]] CellSystem operator[](const std::size_t index) const {
    return {stiffness(index), load(index), dofs(index)};
  }

 private:
  std::vector<Dofs> dofs_;
  std::function<dealii::FullMatrix<double>(std::size_t)> stiffness_;
  std::function<dealii::Vector<double>(std::size_t)> load_;
};

/// In the order of this rank's active cell iterators: K_e u_e = f_e of the principle of virtual
/// work, with body forces and surface loads. They can be asked for until the mesh changes.
/// @param problem in the units of the triangulation
/// @param surfaces boundary names by boundary id
template <int dim>
CellSystems cell_systems(const dealii::DoFHandler<dim>& dof_handler, const Problem<dim>& problem,
                         const std::vector<std::string>& surfaces);

}  // namespace geneva::fem
