#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Core>
#include <vector>

#include "fem/elasticity.h"

namespace geneva::fem {

/// Strain at a point, and the hoop strain u_r/r (0 unless axisymmetric).
template <int dim>
struct Strain {
  dealii::SymmetricTensor<2, dim> tensor;
  double hoop;
};

/// The elastic cell: bilinear or trilinear displacements with the incompatible modes of Taylor,
/// Beresford and Wilson (1976), condensed in the cell.
///
/// Without them cells that are long in a bent body are far too stiff, and nearly incompressible
/// ones lock. The gradient of mode k is J0/J (1 - 2 xi_k - c_k) grad0 xi_k, J0 and grad0 being
/// those of the cell's middle: with c_k = 0, in an axisymmetric model the mean of 1 - 2 xi_k
/// weighted with r, it has no mean over the cell, and uniform stress stays exact. An axisymmetric
/// cell has one mode more, a hoop strain of the shape (1 - 2 xi_1)(1 - 2 xi_2) (Simo and Rifai
/// 1990), without which the dilatation of its vertices' displacements could not vanish everywhere.
template <int dim>
class CellElement {
 public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  static constexpr int n_own = dim * (1 << dim);  ///< displacements of the vertices

  CellElement(const dealii::FiniteElement<dim>& element, const Problem<dim>& problem);

  /// Stiffness of the vertices' displacements with the modes condensed; forces are those of the
  /// whole thickness or turn.
  dealii::FullMatrix<double> stiffness(const Cell& cell);

  /// Strains of the modes that make the cell's energy least under displacements of its vertices.
  /// @param values at the points asked for, of the cell, with its Jacobians
  std::vector<Strain<dim>> mode_strains(const Cell& cell,
                                        const dealii::Vector<double>& displacement,
                                        const dealii::FEValues<dim>& values);

 private:
  static constexpr int n_nodes = 1 << dim;
  static constexpr int n_points = 1 << dim;  // Gauss
  static constexpr int n_functions = n_nodes + dim;
  /// Displacements of the modes of xi_1, then of xi_2, ...; in the plane the hoop strain last.
  static constexpr int most_modes = dim * dim + (dim == 2 ? 1 : 0);
  static constexpr int n_all = n_own + most_modes;
  using Weights = Eigen::Matrix<double, n_points, 1>;
  /// Gradients of scalar functions at the points, those of a function after each other.
  template <int n>
  using Gradients = Eigen::Matrix<double, dim * n, n_points>;
  using Stiffness = Eigen::Matrix<double, n_all, n_all>;
  using ModeShapes = Eigen::Matrix<double, 3, 1>;

  [[nodiscard]] bool is_axisymmetric() const;
  /// Modes that this kind of model has.
  [[nodiscard]] int n_modes() const { return dim * dim + (is_axisymmetric() ? 1 : 0); }
  [[nodiscard]] Weights weights() const;
  [[nodiscard]] Gradients<n_functions> gradients() const;
  [[nodiscard]] Stiffness whole_stiffness(const Cell& cell);
  /// Means of the reference shapes over the current cell, weighted with r; 0 unless axisymmetric.
  [[nodiscard]] ModeShapes means() const;
  void add_hoop_stiffness(const Lame& constants, const Gradients<n_functions>& gradients,
                          const Weights& weights, Stiffness& stiffness) const;
  /// Shapes at a reference point: 1 - 2 xi_k for all k, in the plane then their product.
  static ModeShapes reference_shapes(const dealii::Point<dim>& xi);
  /// Those less their means over the cell, times J0/J.
  [[nodiscard]] ModeShapes mode_shapes(const dealii::FEValues<dim>& values,
                                       unsigned int point) const;

  Problem<dim> problem_;
  std::vector<Lame> lame_;
  dealii::FEValues<dim> values_;
  dealii::FEValues<dim> centre_;
  ModeShapes means_ = ModeShapes::Zero();  ///< of the current cell
};

/// Strains of a displacement field, with the modes of the cells, at the points of a quadrature.
template <int dim>
class CellStrains {
 public:
  CellStrains(const dealii::FiniteElement<dim>& element, const Problem<dim>& problem,
              const dealii::Quadrature<dim>& points);

  /// @param displacement ghosted
  template <typename Vector>
  std::vector<Strain<dim>> operator()(const typename CellElement<dim>::Cell& cell,
                                      const Vector& displacement) {
    cell->get_dof_values(displacement, cell_displacement_);
    return strains(cell);
  }

  [[nodiscard]] const dealii::FEValues<dim>& values() const { return values_; }

 private:
  std::vector<Strain<dim>> strains(const typename CellElement<dim>::Cell& cell);

  CellElement<dim> element_;
  bool is_axisymmetric_;
  dealii::FEValues<dim> values_;
  dealii::Vector<double> cell_displacement_;
};

}  // namespace geneva::fem
