#include "fem/discretisation/round_cell.h"

#include <deal.II/base/array_view.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>

namespace geneva::fem {

namespace {

using dealii::Point;

/// Reference directions of a cell along which its face lies.
template <int dim>
std::array<unsigned int, static_cast<std::size_t>(dim - 1)> directions_in(const unsigned int face) {
  if constexpr (dim == 2)
    return {1 - face / 2};
  else
    return {face / 2 == 0   ? 1U
            : face / 2 == 1 ? 2U
                            : 0U,
            face / 2 == 0   ? 2U
            : face / 2 == 1 ? 0U
                            : 1U};
}

/// From the middle of the chord between two points to that of the curve, without the part along the
/// chord, which is grading and not curvature.
template <int dim>
dealii::Tensor<1, dim> sagitta(const dealii::Manifold<dim>& manifold, const Point<dim>& begin,
                               const Point<dim>& end) {
  const dealii::Tensor<1, dim> along = (end - begin) / begin.distance(end);
  const dealii::Tensor<1, dim> offset =
      middle_of_curve(manifold, begin, end) - (begin + 0.5 * (end - begin));
  return offset - (offset * along) * along;
}

/// The angle by which a curve of this sagitta turns.
double angle(const double sagitta, const double length) {
  return 4. * std::atan(2. * sagitta / length);
}

/// Chords that a curve between two points takes.
template <int dim>
unsigned int chords(const dealii::Manifold<dim>& manifold, const Point<dim>& begin,
                    const Point<dim>& end) {
  constexpr double turn = 2.5 * 3.14159265358979 / 180.;
  const double turns = angle(sagitta(manifold, begin, end).norm(), begin.distance(end)) / turn;
  return std::max(1U, static_cast<unsigned int>(std::ceil(turns - 1e-6)));
}

/// Bilinear weights of a face's vertices.
template <int dim>
std::array<double, dealii::GeometryInfo<dim>::vertices_per_face> weights(
    const Point<dim - 1>& reference) {
  std::array<double, dealii::GeometryInfo<dim>::vertices_per_face> result;
  for (unsigned int i = 0; i < result.size(); ++i)
    result[i] = dealii::GeometryInfo<dim - 1>::d_linear_shape_function(reference, i);
  return result;
}

}  // namespace

template <int dim>
Point<dim> middle_of_curve(const dealii::Manifold<dim>& surface, const Point<dim>& begin,
                           const Point<dim>& end) {
  const std::array<Point<dim>, 2> ends{begin, end};
  const std::array<double, 2> shares{0.5, 0.5};
  return surface.get_new_point(dealii::ArrayView<const Point<dim>>(ends.data(), ends.size()),
                               dealii::ArrayView<const double>(shares.data(), shares.size()));
}

double length_over_notch_radius(const dealii::Triangulation<3>::cell_iterator& cell,
                                const unsigned int face) {
  const auto& round = cell->face(face);
  const dealii::Tensor<1, 3> outwards = round->center() - cell->center();
  double longest = 0.;
  double curvature = 0.;
  for (const unsigned int i : round->line_indices()) {
    const Point<3> begin = round->line(i)->vertex(0);
    const Point<3> end = round->line(i)->vertex(1);
    const double length = begin.distance(end);
    longest = std::max(longest, length);
    const dealii::Tensor<1, 3> bend = sagitta(round->get_manifold(), begin, end);
    if (bend * outwards < 0.)
      curvature = std::max(curvature, 2. * std::sin(angle(bend.norm(), length) / 2.) / length);
  }
  return longest * curvature;
}

template <int dim>
RoundCell<dim>::RoundCell(const Cell& cell) : cell_(cell) {
  parts_.fill(1);
  if (!cell->at_boundary()) return;
  for (const unsigned int face : cell->face_indices()) {
    if (!fem::is_round(cell->face(face))) continue;
    faces_.push_back(face);
    const auto directions = directions_in<dim>(face);
    const auto& manifold = cell->face(face)->get_manifold();
    const auto vertex = [&](const unsigned int i) {
      return cell->vertex(dealii::GeometryInfo<dim>::face_to_cell_vertices(face, i));
    };
    const auto add = [&](const std::size_t direction, const unsigned int begin,
                         const unsigned int end) {
      unsigned int& parts = parts_[directions[direction]];
      parts = std::max(parts, chords<dim>(manifold, vertex(begin), vertex(end)));
    };
    add(0, 0, 1);
    if constexpr (dim == 3) {
      add(0, 2, 3);
      add(1, 0, 2);
      add(1, 1, 3);
    }
  }
}

template <int dim>
std::vector<PartCorner> RoundCell<dim>::first_corners() const {
  PartCorner ends{1, 1, 1};
  std::copy(parts_.begin(), parts_.end(), ends.begin());
  std::vector<PartCorner> corners;
  for (unsigned int k = 0; k < ends[2]; ++k)
    for (unsigned int j = 0; j < ends[1]; ++j)
      for (unsigned int i = 0; i < ends[0]; ++i) corners.push_back({i, j, k});
  return corners;
}

template <int dim>
PartCorner RoundCell<dim>::corner_of_part(PartCorner first, const unsigned int corner) {
  for (unsigned int axis = 0; axis < dim; ++axis) first[axis] += corner >> axis & 1U;
  return first;
}

template <int dim>
PartCorner RoundCell<dim>::at_vertex(const unsigned int vertex) const {
  PartCorner corner{};
  for (unsigned int axis = 0; axis < dim; ++axis)
    corner[axis] = (vertex >> axis & 1U) * parts_[axis];
  return corner;
}

template <int dim>
Point<dim> RoundCell<dim>::reference(const PartCorner& corner) const {
  Point<dim> result;
  for (unsigned int axis = 0; axis < dim; ++axis)
    result[axis] = static_cast<double>(corner[axis]) / parts_[axis];
  return result;
}

template <int dim>
Point<dim> RoundCell<dim>::place(const Point<dim>& reference) const {
  using Geometry = dealii::GeometryInfo<dim>;
  Point<dim> result;
  for (const unsigned int vertex : cell_->vertex_indices())
    result += Geometry::d_linear_shape_function(reference, vertex) * cell_->vertex(vertex);
  for (const unsigned int face : faces_) {
    const auto directions = directions_in<dim>(face);
    Point<dim - 1> on_face;
    for (unsigned int i = 0; i + 1 < dim; ++i) on_face[i] = reference[directions[i]];
    const auto shares = weights<dim>(on_face);
    std::array<Point<dim>, Geometry::vertices_per_face> corners;
    Point<dim> flat;
    for (unsigned int i = 0; i < corners.size(); ++i) {
      corners[i] = cell_->vertex(Geometry::face_to_cell_vertices(face, i));
      flat += shares[i] * corners[i];
    }
    const Point<dim> round = cell_->face(face)->get_manifold().get_new_point(
        dealii::ArrayView<const Point<dim>>(corners.data(), corners.size()),
        dealii::ArrayView<const double>(shares.data(), shares.size()));
    const double across = reference[face / 2];
    result += (face % 2 == 0 ? 1. - across : across) * (round - flat);
  }
  return result;
}

template Point<2> middle_of_curve(const dealii::Manifold<2>&, const Point<2>&, const Point<2>&);
template Point<3> middle_of_curve(const dealii::Manifold<3>&, const Point<3>&, const Point<3>&);
template class RoundCell<2>;
template class RoundCell<3>;

}  // namespace geneva::fem
