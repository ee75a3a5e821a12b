#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <cstddef>
#include <vector>

#include "fem/discretisation/vector.h"

namespace geneva::fem {

/// A cell by its coarse cell and the children on the way to it (dealii::CellId in binary).
using CellName = std::array<unsigned int, 4>;

/// A refined mesh and a displacement on it, which do not depend on the ranks and their shares.
template <int dim>
struct SavedField {
  static constexpr std::size_t corners = std::size_t{1} << dim;

  std::vector<CellName> cells;       ///< all active ones, in ascending order
  std::vector<unsigned int> nodes;   ///< of their corners, cell by cell, in deal.II's order
  std::vector<double> displacement;  ///< in the units of the triangulation, node by node

  [[nodiscard]] std::size_t n_nodes() const { return displacement.size() / dim; }
};

/// Collects the mesh and the displacement of all ranks.
/// @param displacement with ghosts, at least those of each rank's cells
/// @return the same on all ranks
template <int dim>
SavedField<dim> saved_field(const dealii::DoFHandler<dim>& dof_handler, const Vector& displacement);

/// Refines a coarse mesh until it has the saved cells, shared out evenly over the ranks.
/// @param saved the same on all ranks
/// @throws base::InputError if this coarse mesh has no such cells
template <int dim>
void refine_as(dealii::parallel::distributed::Triangulation<dim>& triangulation,
               const SavedField<dim>& saved);

/// The saved displacement on the mesh that refine_as() made, without ghosts.
template <int dim>
Vector field_on(const dealii::DoFHandler<dim>& dof_handler, const SavedField<dim>& saved);

/// @throws base::InputError unless cells are in order, indices in range and values finite
template <int dim>
void check(const SavedField<dim>& saved);

}  // namespace geneva::fem
