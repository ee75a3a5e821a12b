#include "fem/elasticity/cell_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstddef>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Component of a strain that the derivative j of a displacement along i belongs to; -1: none.
template <int dim>
constexpr std::array<std::array<int, 3>, 3> component_of =
    dim == 2 ? std::array<std::array<int, 3>, 3>{{{0, 3, 2}, {3, 1, -1}, {-1, -1, -1}}}
             : std::array<std::array<int, 3>, 3>{{{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}};

/// C_ij,kl of the derivatives j of displacements along i and l of those along k, by (i, k), (j, l).
template <int dim>
Eigen::Matrix<double, dim * dim, 9> by_derivatives(const Tangent<dim>& tangent) {
  Eigen::Matrix<double, dim * dim, 9> result;
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k < dim; ++k)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l) {
          const int row =
              component_of<dim>[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
          const int column =
              component_of<dim>[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
          result(i + dim * k, j + 3 * l) = row < 0 || column < 0 ? 0. : tangent(row, column);
        }
  return result;
}

/// What is left of a stiffness, of which the lower triangle is given and kept, when the force of
/// its last displacement is none: K_ij - K_ni K_nj/K_nn for i, j < n.
template <class Matrix>
void eliminate(const int last, Matrix& stiffness) {
  for (int j = 0; j < last; ++j) {
    const double share = stiffness(last, j) / stiffness(last, last);
    for (int i = j; i < last; ++i) stiffness(i, j) -= share * stiffness(last, i);
  }
}

}  // namespace

template <int dim>
CellElement<dim>::CellElement(const Problem<dim>& problem)
    : problem_(problem),
      laws_(material_laws(problem)),
      points_(reference_points<dim>(dealii::QGauss<dim>(2))),
      middle_(reference_points<dim>(dealii::QMidpoint<dim>()).front()) {}

template <int dim>
dealii::FullMatrix<double> CellElement<dim>::stiffness(const Cell& cell) const {
  Stiffness condensed = whole_stiffness(shape(cell), cell->material_id());
  for (int mode = n_own + n_modes() - 1; mode >= n_own; --mode) eliminate(mode, condensed);
  dealii::FullMatrix<double> result(n_own);
  for (int i = 0; i < n_own; ++i)
    for (int j = 0; j < n_own; ++j)
      result(static_cast<unsigned int>(i), static_cast<unsigned int>(j)) =
          condensed(std::max(i, j), std::min(i, j));
  return result;
}

template <int dim>
std::vector<StressVector<dim>> CellElement<dim>::strains(
    const Cell& cell, const dealii::Vector<double>& displacement,
    const std::vector<ReferencePoint<dim>>& points) const {
  const Shape shape = this->shape(cell);
  const Stiffness whole = whole_stiffness(shape, cell->material_id());
  Eigen::Matrix<double, dim, n_functions> amplitudes =
      Eigen::Matrix<double, dim, n_functions>::Zero();
  Eigen::Map<Eigen::Matrix<double, n_all, 1>> all(amplitudes.data());
  all.template head<n_own>() =
      Eigen::Map<const Eigen::Matrix<double, n_own, 1>>(displacement.begin());
  constexpr int most_modes = n_all - n_own;
  using Modes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_modes, most_modes>;
  const Modes modes = whole.block(n_own, n_own, n_modes(), n_modes());
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_modes, 1> load =
      -whole.block(n_own, 0, n_modes(), n_own) * all.template head<n_own>();
  all.segment(n_own, n_modes()) = modes.llt().solve(load);
  std::vector<StressVector<dim>> result(points.size(), StressVector<dim>::Zero());
  for (std::size_t q = 0; q < points.size(); ++q) {
    const Eigen::Matrix<double, dim, 3> gradient =
        amplitudes * derivatives(shape, CellPoint<dim>(shape.vertices, points[q])).transpose();
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < 3; ++j)
        if (const int component =
                component_of<dim>[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            component >= 0)
          result[q][component] += gradient(i, j);
  }
  return result;
}

template <int dim>
bool CellElement<dim>::is_axisymmetric() const {
  return dim == 2 && problem_.plane == PlaneKind::axisymmetric;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::reference_shapes(const Point<dim>& xi) {
  ModeShapes shapes;
  for (unsigned int k = 0; k < dim; ++k) shapes[k] = 1. - 2. * xi[k];
  if (dim == 2) shapes[2] = shapes[0] * shapes[1];
  return shapes;
}

template <int dim>
typename CellElement<dim>::Shape CellElement<dim>::shape(const Cell& cell) const {
  const CellVertices<dim> vertices = vertices_of<dim>(cell);
  return {vertices, CellPoint<dim>(vertices, middle_), means(vertices)};
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::means(
    const CellVertices<dim>& vertices) const {
  ModeShapes sum = ModeShapes::Zero();
  if (dim == 2 && !is_axisymmetric()) return sum;
  double weights = 0.;
  for (const ReferencePoint<dim>& reference : points_) {
    const CellPoint<dim> point(vertices, reference);
    const double weight = dim == 3 ? point.measure : point.place[0];
    sum += weight * reference_shapes(point.xi);
    weights += weight;
  }
  return sum / weights;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::mode_shapes(const Shape& shape,
                                                                    const CellPoint<dim>& point) {
  const double ratio = dim == 3 ? 1. : shape.middle.jacobian / point.jacobian;
  return ratio * (reference_shapes(point.xi) - shape.means);
}

template <int dim>
typename CellElement<dim>::Derivatives CellElement<dim>::derivatives(
    const Shape& shape, const CellPoint<dim>& point) const {
  Derivatives result = Derivatives::Zero();
  result.template topLeftCorner<dim, n_nodes>() = point.gradients;
  const ModeShapes shapes = mode_shapes(shape, point);
  for (int k = 0; k < dim; ++k)
    result.template block<dim, 1>(0, n_nodes + k) =
        shapes[k] * shape.middle.inverse.row(k).transpose();
  if (is_axisymmetric()) add_hoop_strains(shape, point, result);
  return result;
}

/// u_r/r, and the last mode; the modes of the displacement have none. On the axis, where u_r/r has
/// no value of its own, it equals the radial strain.
template <int dim>
void CellElement<dim>::add_hoop_strains(const Shape& shape, const CellPoint<dim>& point,
                                        Derivatives& derivatives) const {
  constexpr int hoop = 2;
  const double radius = point.place[0];
  if (radius < 1e-12) {
    derivatives.row(hoop) = derivatives.row(0);
    return;
  }
  derivatives.template block<1, n_nodes>(hoop, 0) = point.shapes.transpose() / radius;
  derivatives(hoop, n_functions - 1) = mode_shapes(shape, point)[hoop];
}

/// With the tangent C, the same at all points, and the integrals G of derivative j of the function
/// a times derivative l of b, displacements by a along i and by b along k have the stiffness
/// C_ij,kl G_jl.
template <int dim>
typename CellElement<dim>::Stiffness CellElement<dim>::whole_stiffness(
    const Shape& shape, const unsigned int body) const {
  using AtPoints = Eigen::Matrix<double, 3 * n_functions, n_points>;
  using Products = Eigen::Matrix<double, 3 * n_functions, 3 * n_functions>;
  AtPoints derivatives;
  AtPoints weighted;
  for (int q = 0; q < n_points; ++q) {
    const CellPoint<dim> point(shape.vertices, points_[static_cast<std::size_t>(q)]);
    const Derivatives here = this->derivatives(shape, point);
    derivatives.col(q) = Eigen::Map<const Eigen::Matrix<double, 3 * n_functions, 1>>(here.data());
    weighted.col(q) =
        (dim == 3 ? point.measure : point.measure * out_of_plane_measure(problem_, point.place)) *
        derivatives.col(q);
  }
  const Products products = dim == 2 ? Products(weighted.lazyProduct(derivatives.transpose()))
                                     : Products(weighted * derivatives.transpose());
  const auto tangent =
      by_derivatives<dim>(laws_[body]->respond(StressVector<dim>::Zero(), {}).tangent);
  Stiffness result;
  for (int a = 0; a < n_functions; ++a)
    for (int b = 0; b <= a; ++b) {
      const Eigen::Matrix3d product = products.template block<3, 3>(3 * a, 3 * b);
      const Eigen::Matrix<double, dim * dim, 1> block =
          tangent.lazyProduct(Eigen::Map<const Eigen::Matrix<double, 9, 1>>(product.data()));
      result.template block<dim, dim>(dim * a, dim * b) =
          Eigen::Map<const Eigen::Matrix<double, dim, dim>>(block.data());
    }
  return result;
}

template <int dim>
CellStresses<dim>::CellStresses(const Problem<dim>& problem, const dealii::Quadrature<dim>& points)
    : element_(problem),
      laws_(material_laws(problem)),
      points_(reference_points(points)),
      cell_displacement_(CellElement<dim>::n_own) {}

template <int dim>
std::vector<PointStress<dim>> CellStresses<dim>::stresses(
    const typename CellElement<dim>::Cell& cell) const {
  const CellVertices<dim> vertices = vertices_of<dim>(cell);
  const std::vector<StressVector<dim>> strains =
      element_.strains(cell, cell_displacement_, points_);
  std::vector<PointStress<dim>> result;
  for (std::size_t q = 0; q < points_.size(); ++q) {
    const CellPoint<dim> point(vertices, points_[q]);
    const StressVector<dim> stress = laws_[cell->material_id()]->respond(strains[q], {}).stress;
    result.push_back({point.place, point.measure,
                      assembled_stress<dim>([&](const unsigned int i) { return stress[i]; })});
  }
  return result;
}

template class CellElement<2>;
template class CellElement<3>;
template class CellStresses<2>;
template class CellStresses<3>;

}  // namespace geneva::fem
