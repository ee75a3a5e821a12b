#pragma once

#include <deal.II/distributed/cell_data_transfer.h>
#include <deal.II/distributed/tria.h>

#include <optional>
#include <vector>

namespace geneva::fem {

/// Numbers at the Gauss points of cells, 2 in each direction in the order of dealii::QGauss: by the
/// active index of this rank's cells, then by point. Empty where there are none on any rank.
using PointValues = std::vector<std::vector<std::vector<double>>>;

/// Carries values at Gauss points over to another mesh or distribution of cells. A point of a finer
/// cell gets the values of the nearest point of the cell that it is part of.
template <int dim>
class PointValueTransfer {
 public:
  /// Before the triangulation changes.
  PointValueTransfer(const dealii::parallel::distributed::Triangulation<dim>& triangulation,
                     const PointValues& values);

  /// After it has changed.
  PointValues carried();

 private:
  using Transfer = dealii::parallel::distributed::CellDataTransfer<dim, dim, PointValues>;

  const dealii::parallel::distributed::Triangulation<dim>& triangulation_;
  std::optional<Transfer> transfer_;
};

}  // namespace geneva::fem
