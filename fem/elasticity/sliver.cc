#include "fem/elasticity/sliver.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/manifold.h>

#include <array>

#include "fem/discretisation/round_cell.h"
#include "fem/elasticity/surface_stress.h"

namespace geneva::fem {

namespace {

using dealii::Point;
using dealii::Tensor;

template <int dim>
using RoundFaceCell = typename dealii::DoFHandler<dim>::active_cell_iterator;

template <int dim>
const Point<dim>& corner(const RoundFaceCell<dim>& cell, const unsigned int face,
                         const unsigned int vertex) {
  return cell->vertex(dealii::GeometryInfo<dim>::face_to_cell_vertices(face, vertex));
}

/// From the middle of the chord between two corners of a face to that of the true curve.
template <int dim>
Tensor<1, dim> rise(const RoundFaceCell<dim>& cell, const unsigned int face,
                    const unsigned int begin, const unsigned int end) {
  const Point<dim>& from = corner<dim>(cell, face, begin);
  const Point<dim>& to = corner<dim>(cell, face, end);
  const Point<dim> middle = middle_of_curve(cell->face(face)->get_manifold(), from, to);
  return middle - from - 0.5 * (to - from);
}

/// Those of a face's edges, along its first coordinate and along its second.
template <int dim>
using Rises = std::array<Tensor<1, dim>, dim == 2 ? 1 : 4>;

Rises<2> rises(const RoundFaceCell<2>& cell, const unsigned int face) {
  return {rise<2>(cell, face, 0, 1)};
}

Rises<3> rises(const RoundFaceCell<3>& cell, const unsigned int face) {
  return {rise<3>(cell, face, 0, 1), rise<3>(cell, face, 2, 3), rise<3>(cell, face, 0, 2),
          rise<3>(cell, face, 1, 3)};
}

/// Vector of the sliver's thickness over a reference point of the face.
Tensor<1, 2> thickness(const Rises<2>& rises, const Point<1>& xi) {
  return 4. * xi[0] * (1. - xi[0]) * rises[0];
}

Tensor<1, 3> thickness(const Rises<3>& rises, const Point<2>& xi) {
  const auto between = [&](const std::size_t first, const double at) {
    return (1. - at) * rises[first] + at * rises[first + 1];
  };
  return 4. * xi[0] * (1. - xi[0]) * between(0, xi[1]) +
         4. * xi[1] * (1. - xi[1]) * between(2, xi[0]);
}

Tensor<1, 2> across(const std::array<Tensor<1, 2>, 1>& tangents) {
  return dealii::cross_product_2d(tangents[0]);
}
Tensor<1, 3> across(const std::array<Tensor<1, 3>, 2>& tangents) {
  return dealii::cross_product_3d(tangents[0], tangents[1]);
}

/// Unit vectors reciprocal to the tangents, in the face.
std::array<Tensor<1, 2>, 1> reciprocal(const std::array<Tensor<1, 2>, 1>& tangents,
                                       const Tensor<1, 2>& /*normal*/) {
  return {tangents[0] / tangents[0].norm_square()};
}
std::array<Tensor<1, 3>, 2> reciprocal(const std::array<Tensor<1, 3>, 2>& tangents,
                                       const Tensor<1, 3>& normal) {
  const Tensor<1, 3> first = dealii::cross_product_3d(tangents[1], normal);
  const Tensor<1, 3> second = dealii::cross_product_3d(normal, tangents[0]);
  return {first / (first * tangents[0]), second / (second * tangents[1])};
}

}  // namespace

template <int dim>
unsigned int Slivers<dim>::cell_dof(const unsigned int face, const int face_dof) {
  const auto dof = static_cast<unsigned int>(face_dof);
  return dim * dealii::GeometryInfo<dim>::face_to_cell_vertices(face, dof / dim) + dof % dim;
}

template <int dim>
Slivers<dim>::Slivers(const Problem<dim>& problem)
    : problem_(problem), laws_(material_laws(problem)) {}

template <int dim>
auto Slivers<dim>::points(const Cell& cell, const unsigned int face) const
    -> std::array<FacePoint, n_points> {
  using Reference = dealii::GeometryInfo<dim - 1>;
  const dealii::QGauss<dim - 1> quadrature(2);
  const Rises<dim> rises = fem::rises(cell, face);
  std::array<FacePoint, n_points> result;
  for (unsigned int q = 0; q < quadrature.size(); ++q) {
    const Point<dim - 1>& xi = quadrature.point(q);
    Point<dim> place;
    std::array<Tensor<1, dim>, static_cast<std::size_t>(dim - 1)> tangents;
    for (unsigned int vertex = 0; vertex < n_vertices; ++vertex) {
      const Point<dim>& end = corner<dim>(cell, face, vertex);
      place += Reference::d_linear_shape_function(xi, vertex) * end;
      const auto gradient = Reference::d_linear_shape_function_gradient(xi, vertex);
      for (unsigned int k = 0; k + 1 < dim; ++k) tangents[k] += gradient[k] * end;
    }
    FacePoint& point = result[q];
    point.normal = across(tangents);
    const double area = point.normal.norm();
    point.normal /=
        (point.normal * (cell->face(face)->center() - cell->center()) > 0. ? 1. : -1.) * area;
    const auto axes = reciprocal(tangents, point.normal);
    const bool has_hoop = dim == 2 && problem_.plane == PlaneKind::axisymmetric && place[0] > 0.;
    for (unsigned int vertex = 0; vertex < n_vertices; ++vertex) {
      const auto slope = Reference::d_linear_shape_function_gradient(xi, vertex);
      Tensor<1, dim> gradient;
      for (unsigned int k = 0; k + 1 < dim; ++k) gradient += slope[k] * axes[k];
      point.gradients[vertex] = gradient;
      point.hoop[vertex] =
          has_hoop ? Reference::d_linear_shape_function(xi, vertex) / place[0] : 0.;
    }
    point.volume = quadrature.weight(q) * area * (thickness(rises, xi) * point.normal) *
                   out_of_plane_measure(problem_, place);
  }
  return result;
}

template <int dim>
typename Slivers<dim>::FaceStrains Slivers<dim>::strains(const FacePoint& point) {
  FaceStrains result;
  Eigen::Index column = 0;
  for (std::size_t vertex = 0; vertex < point.gradients.size(); ++vertex)
    for (unsigned int component = 0; component < dim; ++component) {
      Tensor<2, dim> gradient;
      gradient[component] = point.gradients[vertex];
      result.col(column++) = strain_of<dim>(gradient, component == 0 ? point.hoop[vertex] : 0.);
    }
  return result;
}

template <int dim>
void Slivers<dim>::add_stiffness(const Cell& cell, dealii::FullMatrix<double>& stiffness) const {
  for (const unsigned int face : cell->face_indices()) {
    if (!is_round(cell->face(face))) continue;
    const Tangent<dim> tangent =
        laws_[cell->material_id()]->respond(StressVector<dim>::Zero(), {}).tangent;
    Eigen::Matrix<double, n_face_dofs, n_face_dofs> sum;
    sum.setZero();
    for (const FacePoint& point : points(cell, face)) {
      const FaceStrains strains = Slivers::strains(point);
      FaceStrains stresses = surface_tangent(tangent, point.normal) * strains;
      stresses *= point.volume;
      sum.noalias() += strains.transpose() * stresses;
    }
    for (int j = 0; j < n_face_dofs; ++j)
      for (int i = 0; i < n_face_dofs; ++i)
        stiffness(cell_dof(face, i), cell_dof(face, j)) += sum(i, j);
  }
}

template <int dim>
void Slivers<dim>::add_load(const Cell& cell, const unsigned int face, const double pressure,
                            const Tensor<1, dim>& shear, dealii::Vector<double>& load) const {
  for (const FacePoint& point : points(cell, face)) {
    const Eigen::Matrix<double, n_face_dofs, 1> forces =
        point.volume * (strains(point).transpose() *
                        surface_stress(*laws_[cell->material_id()], Tensor<2, dim>(), 0.,
                                       point.normal, shear - pressure * point.normal));
    for (int i = 0; i < n_face_dofs; ++i) load[cell_dof(face, i)] -= forces[i];
  }
}

template class Slivers<2>;
template class Slivers<3>;

}  // namespace geneva::fem
