#include "fem/contact/mortar.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "fem/contact/projection.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Shares of a source node's edges that must be covered by the target for the node to take part in
/// the contact.
constexpr double least_coverage = 1e-6;

/// A quadrature point on the overlap of a source and a target edge.
struct OverlapPoint {
  std::array<double, 2> source_shapes;
  std::array<double, 2> target_shapes;
  std::array<unsigned int, 2> target_nodes;
  Tensor<1, 2> normal;  ///< of the target
  double gap;
  double weight;
};

/// xi (1 - xi) h^2/2: how far a parabola of unit curvature is from its chord.
double bubble(const Surface& surface, const SurfaceFace& face, const double xi) {
  const double length_square =
      surface.nodes[face.nodes[0]].position.distance_square(surface.nodes[face.nodes[1]].position);
  return 0.5 * xi * (1. - xi) * length_square;
}

OverlapPoint overlap_point(const Surface& source, const SurfaceFace& source_face, const double xi,
                           const Surface& target, const SurfaceFace& target_face,
                           const double weight, const double source_share) {
  const Point<2> source_point =
      true_point(source, source_face, chord_point(source, source_face, xi));
  const double eta = project_on_face(target, target_face, source_point);
  const Point<2> target_point =
      true_point(target, target_face, chord_point(target, target_face, eta));
  const Tensor<1, 2> normal = face_normal(target, target_face, eta);
  const double relative_curvature = curvature(source, source_face) + curvature(target, target_face);
  const double missed = source_share * bubble(source, source_face, xi) +
                        (1. - source_share) * bubble(target, target_face, eta);
  return {{1. - xi, xi},
          {1. - eta, eta},
          target_face.nodes,
          normal,
          (source_point - target_point) * normal + relative_curvature * missed,
          weight};
}

/// Gauss points on all overlaps of one source edge with the target.
std::vector<OverlapPoint> overlap_points(const Surface& source, const SurfaceFace& source_face,
                                         const Surface& target, const MortarData& data) {
  static const dealii::QGauss<1> rule(4);
  const double length = source.nodes[source_face.nodes[0]].position.distance(
      source.nodes[source_face.nodes[1]].position);
  std::vector<OverlapPoint> points;
  for (const Overlap& overlap : overlaps(source, source_face, target))
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double xi = overlap.begin + rule.point(q)[0] * (overlap.end - overlap.begin);
      const double weight = rule.weight(q) * (overlap.end - overlap.begin) * length *
                            data.measure(chord_point(source, source_face, xi));
      points.push_back(overlap_point(source, source_face, xi, target,
                                     target.faces[overlap.target_face], weight, data.source_share));
    }
  return points;
}

/// Coefficients A = D_e M_e^-1 of the dual basis psi_i = sum_k A_ik N_k on the covered part of one
/// edge.
using DualBasis = std::array<std::array<double, 2>, 2>;

std::optional<DualBasis> dual_basis(const std::vector<OverlapPoint>& points) {
  double m00 = 0., m01 = 0., m11 = 0.;
  for (const OverlapPoint& p : points) {
    m00 += p.weight * p.source_shapes[0] * p.source_shapes[0];
    m01 += p.weight * p.source_shapes[0] * p.source_shapes[1];
    m11 += p.weight * p.source_shapes[1] * p.source_shapes[1];
  }
  const double determinant = m00 * m11 - m01 * m01;
  if (determinant <= 1e-14 * (m00 + m11) * (m00 + m11)) return std::nullopt;
  const double d0 = m00 + m01;
  const double d1 = m01 + m11;
  return DualBasis{{{d0 * m11 / determinant, -d0 * m01 / determinant},
                    {-d1 * m01 / determinant, d1 * m00 / determinant}}};
}

/// A row under construction.
struct RowSum {
  double weight = 0.;
  double full_weight = 0.;
  Tensor<1, 2> normal;
  double gap = 0.;
  std::map<unsigned int, Tensor<1, 2>> coupling;
};

void add_face(const Surface& source, const SurfaceFace& face, const Surface& target,
              const MortarData& data, std::vector<RowSum>& rows) {
  const double length =
      source.nodes[face.nodes[0]].position.distance(source.nodes[face.nodes[1]].position);
  for (const unsigned int node : face.nodes)
    rows[node].full_weight += 0.5 * length * data.measure(chord_point(source, face, 0.5));

  const auto points = overlap_points(source, face, target, data);
  const auto basis = dual_basis(points);
  if (!basis) return;
  for (const OverlapPoint& p : points)
    for (const unsigned int i : {0U, 1U}) {
      const double psi = (*basis)[i][0] * p.source_shapes[0] + (*basis)[i][1] * p.source_shapes[1];
      RowSum& row = rows[face.nodes[i]];
      row.weight += p.weight * p.source_shapes[i];
      row.normal += p.weight * psi * p.normal;
      row.gap += p.weight * psi * p.gap;
      for (const unsigned int k : {0U, 1U})
        row.coupling[p.target_nodes[k]] += p.weight * psi * p.target_shapes[k] * p.normal;
    }
}

}  // namespace

std::vector<MortarRow> mortar_rows(const Surface& source, const Surface& target,
                                   const MortarData& data) {
  std::vector<RowSum> sums(source.nodes.size());
  for (const SurfaceFace& face : source.faces) add_face(source, face, target, data, sums);

  std::vector<MortarRow> rows;
  for (unsigned int node = 0; node < sums.size(); ++node) {
    const RowSum& sum = sums[node];
    if (sum.weight <= least_coverage * sum.full_weight) continue;
    rows.push_back({node,
                    sum.weight,
                    sum.normal / sum.weight,
                    sum.gap,
                    {sum.coupling.begin(), sum.coupling.end()}});
  }
  return rows;
}

}  // namespace geneva::fem
