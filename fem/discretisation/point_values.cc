#include "fem/discretisation/point_values.h"

#include <deal.II/distributed/cell_data_transfer.templates.h>

namespace geneva::fem {

namespace {

using CellValues = PointValues::value_type;

/// Child k of a cell lies around its Gauss point k: all of its points are nearest to that.
template <int dim>
std::vector<CellValues> values_of_children(
    const typename dealii::Triangulation<dim>::cell_iterator& parent, const CellValues& values) {
  std::vector<CellValues> children;
  for (std::size_t child = 0; child < parent->n_children(); ++child)
    children.push_back(values.empty() ? CellValues{} : CellValues(values.size(), values[child]));
  return children;
}

/// Cells are never made coarser.
template <int dim>
CellValues values_of_parent(const typename dealii::Triangulation<dim>::cell_iterator& /*parent*/,
                            const std::vector<CellValues>& children) {
  return children.front();
}

}  // namespace

template <int dim>
PointValueTransfer<dim>::PointValueTransfer(
    const dealii::parallel::distributed::Triangulation<dim>& triangulation,
    const PointValues& values)
    : triangulation_(triangulation) {
  if (values.empty()) return;
  constexpr bool sizes_vary = true;  // a cell's body may remember nothing
  transfer_.emplace(triangulation, sizes_vary, &values_of_children<dim>, &values_of_parent<dim>);
  transfer_->prepare_for_coarsening_and_refinement(values);
}

template <int dim>
PointValues PointValueTransfer<dim>::carried() {
  if (!transfer_) return {};
  PointValues result(triangulation_.n_active_cells());
  transfer_->unpack(result);
  return result;
}

template class PointValueTransfer<2>;
template class PointValueTransfer<3>;

}  // namespace geneva::fem
