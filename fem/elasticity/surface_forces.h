#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <set>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/elasticity/cell_systems.h"

namespace geneva::fem {

/// Unknowns at which contact, supports and ties can exert forces, and K u - f there.
struct ForcedUnknowns {
  /// What a cell adds to a force: a line of K times the cell's displacements, less the load.
  struct Share {
    std::size_t in;  ///< place in dofs
    std::vector<double> stiffness;
    double load;
  };
  struct Cell {
    std::vector<dealii::types::global_dof_index> dofs;
    std::vector<Share> shares;
  };

  std::vector<dealii::types::global_dof_index> dofs;  ///< ascending, the same on all ranks
  std::vector<Cell> cells;                            ///< of this rank that have shares
};

/// The hanging nodes' forces are given to the nodes that they hang on.
/// @param dofs the same on all ranks
/// @param cells of this rank
/// @param hanging constraints of the hanging nodes
ForcedUnknowns forced_unknowns(const std::set<dealii::types::global_dof_index>& dofs,
                               const CellSystems& cells,
                               const dealii::AffineConstraints<double>& hanging);

/// Forces that act on the bodies beside the known loads, the same on all ranks.
class SurfaceForces {
 public:
  SurfaceForces() = default;
  /// @param dofs ascending
  /// @param values one for each of them
  SurfaceForces(std::vector<dealii::types::global_dof_index> dofs, std::vector<double> values);

  /// @param dof one of those unknowns
  /// @throws std::out_of_range if it is none
  [[nodiscard]] double operator()(dealii::types::global_dof_index dof) const;

 private:
  std::vector<dealii::types::global_dof_index> dofs_;
  std::vector<double> values_;
};

/// K u - f at the unknowns.
/// @param displacement u, with ghosts
SurfaceForces surface_forces(const ForcedUnknowns& unknowns, const Vector& displacement);

}  // namespace geneva::fem
