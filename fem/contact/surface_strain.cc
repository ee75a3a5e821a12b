#include "fem/contact/surface_strain.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cstddef>

namespace geneva::fem {

namespace {

/// Where a row's node is, and how it and the target there are displaced.
struct SurfacePoint {
  dealii::Point<2> place;
  dealii::Tensor<1, 2> source;
  dealii::Tensor<1, 2> target;
};

dealii::Tensor<1, 2> displacement_of(const SurfaceNode<2>& node, const Vector& displacement) {
  return dealii::Tensor<1, 2>({displacement(node.dofs[0]), displacement(node.dofs[1])});
}

std::vector<SurfacePoint> surface_points(const ContactInterface<2>& interface,
                                         const Vector& displacement) {
  std::vector<SurfacePoint> points;
  for (const ContactRow<2>& row : interface.rows) {
    const SurfaceNode<2>& node = interface.source.nodes[row.node];
    dealii::Tensor<1, 2> target;
    for (const auto& [index, coupling] : row.coupling)
      target += coupling * displacement_of(interface.target.nodes[index], displacement);
    points.push_back({node.position, displacement_of(node, displacement), target / row.weight});
  }
  return points;
}

/// Along the chord from the point before to the point behind.
SurfaceStrain strain_at(const SurfacePoint& before, const SurfacePoint& here,
                        const SurfacePoint& behind) {
  const dealii::Tensor<1, 2> chord = behind.place - before.place;
  const dealii::Tensor<1, 2> tangent = chord / chord.norm();
  const double first = here.place.distance(before.place);
  const double second = behind.place.distance(here.place);
  const auto along = [&](const dealii::Tensor<1, 2>& u0, const dealii::Tensor<1, 2>& u1,
                         const dealii::Tensor<1, 2>& u2) {
    if (first == 0. || second == 0.) return tangent * (u2 - u0) / (first + second);
    return tangent * ((u1 - u0) * second / first + (u2 - u1) * first / second) / (first + second);
  };
  return {along(before.source, here.source, behind.source),
          along(before.target, here.target, behind.target)};
}

}  // namespace

std::vector<SurfaceStrain> surface_strains(const ContactInterface<2>& interface,
                                           const Vector& displacement) {
  const std::vector<SurfacePoint> points = surface_points(interface, displacement);
  if (points.size() < 2) return std::vector<SurfaceStrain>(points.size());
  std::vector<SurfaceStrain> strains;
  for (std::size_t i = 0; i < points.size(); ++i)
    strains.push_back(strain_at(points[i == 0 ? 0 : i - 1], points[i],
                                points[std::min(i + 1, points.size() - 1)]));
  return strains;
}

}  // namespace geneva::fem
