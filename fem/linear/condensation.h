#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <vector>

#include "fem/elasticity/cell_systems.h"

namespace geneva::fem {

/// The unknowns that some unknowns depend on by constraints, or themselves, ascending.
/// @param constraints closed
std::vector<dealii::types::global_dof_index> free_unknowns(
    const std::vector<dealii::types::global_dof_index>& unknowns,
    const dealii::AffineConstraints<double>& constraints);

/// A cell's system in the unknowns that constraints u = C v + g leave free: (C^T K C) v =
/// C^T (f - K g) (Shephard 1984, Linear multipoint constraints applied via transformation as part
/// of a direct stiffness assembly process).
/// @param constraints closed
/// @param is_wanted whether an unknown's line of the matrix is; other lines are left zero
CellSystem condensed(
    const CellSystem& cell, const dealii::AffineConstraints<double>& constraints,
    const std::function<bool(dealii::types::global_dof_index)>& is_wanted = [](const auto) {
      return true;
    });

}  // namespace geneva::fem
