#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Core>
#include <vector>

#include "fem/elasticity/cell_point.h"
#include "fem/elasticity/material_law.h"

namespace geneva::fem {

/// The elastic cell: bilinear or trilinear displacements with the incompatible modes of Taylor,
/// Beresford and Wilson (1976), condensed in the cell.
///
/// Without them cells that are long in a bent body are far too stiff, and nearly incompressible
/// ones lock. The gradient of mode k is J0/J (1 - 2 xi_k - c_k) grad0 xi_k, J0 and grad0 being
/// those of the cell's middle: with c_k = 0, in an axisymmetric model the mean of 1 - 2 xi_k
/// weighted with r, it has no mean over the cell, and uniform stress stays exact. In 3-D c_k is the
/// mean and J0/J left away: of a cell that is long along z and distorted across it the mode along z
/// would vary with J over its cross-section, which is a shear that keeps it from bending. An
/// axisymmetric cell has one mode more, a hoop strain of the shape (1 - 2 xi_1)(1 - 2 xi_2) (Simo
/// and Rifai 1990), without which the dilatation of its vertices' displacements could not vanish
/// everywhere.
template <int dim>
class CellElement {
 public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  static constexpr int n_own = dim * (1 << dim);  ///< displacements of the vertices

  explicit CellElement(const Problem<dim>& problem);

  /// Stiffness of the vertices' displacements with the modes condensed; forces are those of the
  /// whole thickness or turn.
  [[nodiscard]] dealii::FullMatrix<double> stiffness(const Cell& cell) const;

  /// Strains, with those of the modes that make the cell's energy least under displacements of its
  /// vertices.
  [[nodiscard]] std::vector<StressVector<dim>> strains(
      const Cell& cell, const dealii::Vector<double>& displacement,
      const std::vector<ReferencePoint<dim>>& points) const;

 private:
  static constexpr int n_nodes = 1 << dim;
  static constexpr int n_points = 1 << dim;  // Gauss
  /// Scalar functions: of the vertices, of the modes of xi_1, xi_2, ..., and in the plane that of
  /// the hoop strain.
  static constexpr int n_functions = n_nodes + dim + (dim == 2 ? 1 : 0);
  /// Displacements by each function along x, then y, ...; the last function has only a hoop strain,
  /// which counts as displacement along x.
  static constexpr int n_all = dim * n_functions;
  /// By x, y, z of every function; in the plane by x and y, and what the function along x gives to
  /// the hoop strain, f/r.
  using Derivatives = Eigen::Matrix<double, 3, n_functions>;
  using Stiffness = Eigen::Matrix<double, n_all, n_all>;
  using ModeShapes = Eigen::Matrix<double, 3, 1>;

  /// A cell's vertices and what its modes need of them.
  struct Shape {
    CellVertices<dim> vertices;
    CellPoint<dim> middle;
    /// Of the reference shapes over the cell, in an axisymmetric model weighted with r; not used in
    /// other plane ones.
    ModeShapes means;
  };

  [[nodiscard]] bool is_axisymmetric() const;
  /// Displacements of the modes that this kind of model has.
  [[nodiscard]] int n_modes() const { return dim * dim + (is_axisymmetric() ? 1 : 0); }
  [[nodiscard]] Shape shape(const Cell& cell) const;
  [[nodiscard]] ModeShapes means(const CellVertices<dim>& vertices) const;
  /// @return its lower triangle; what stands above is not set
  [[nodiscard]] Stiffness whole_stiffness(const Shape& shape, unsigned int body) const;
  [[nodiscard]] Derivatives derivatives(const Shape& shape, const CellPoint<dim>& point) const;
  void add_hoop_strains(const Shape& shape, const CellPoint<dim>& point,
                        Derivatives& derivatives) const;
  /// Shapes at a reference point: 1 - 2 xi_k for all k, in the plane then their product.
  static ModeShapes reference_shapes(const dealii::Point<dim>& xi);
  /// Those less their means over the cell, in the plane times J0/J.
  static ModeShapes mode_shapes(const Shape& shape, const CellPoint<dim>& point);

  Problem<dim> problem_;
  MaterialLaws<dim> laws_;
  std::vector<ReferencePoint<dim>> points_;  ///< Gauss
  ReferencePoint<dim> middle_;
};

/// The stress at a point of a cell.
template <int dim>
struct PointStress {
  dealii::Point<dim> place;
  double measure;  ///< area or volume that stands for the point in its quadrature
  Stress<dim> stress;
};

/// Stresses of a displacement field, from the strains and the law with which the cells resist it,
/// at the points of a quadrature.
template <int dim>
class CellStresses {
 public:
  CellStresses(const Problem<dim>& problem, const dealii::Quadrature<dim>& points);

  /// @param displacement ghosted
  template <typename Vector>
  std::vector<PointStress<dim>> operator()(const typename CellElement<dim>::Cell& cell,
                                           const Vector& displacement) {
    cell->get_dof_values(displacement, cell_displacement_);
    return stresses(cell);
  }

 private:
  [[nodiscard]] std::vector<PointStress<dim>> stresses(
      const typename CellElement<dim>::Cell& cell) const;

  CellElement<dim> element_;
  MaterialLaws<dim> laws_;
  std::vector<ReferencePoint<dim>> points_;
  dealii::Vector<double> cell_displacement_;
};

}  // namespace geneva::fem
