#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <map>
#include <optional>

namespace geneva::fem {

/// Stiffness matrices of cells of one mesh, for the cells that a refined mesh still has.
template <int dim>
class StiffnessStore {
 public:
  using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

  void keep(const Cell& cell, dealii::FullMatrix<double> stiffness);

  /// Takes the cell's matrix out of the store; nothing if it has none, or if the cell's vertices
  /// have moved since.
  [[nodiscard]] std::optional<dealii::FullMatrix<double>> take(const Cell& cell);

 private:
  static constexpr auto n_vertices =
      static_cast<std::size_t>(dealii::GeometryInfo<dim>::vertices_per_cell);
  using Vertices = std::array<dealii::Point<dim>, n_vertices>;

  struct Kept {
    Vertices vertices;
    dealii::FullMatrix<double> stiffness;
  };

  static Vertices vertices_of(const Cell& cell);

  std::map<dealii::CellId, Kept> kept_;
};

}  // namespace geneva::fem
