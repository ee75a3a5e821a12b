#include <deal.II/base/quadrature_lib.h>

#include "fem/contact/overlap.h"
#include "fem/contact/projection.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// xi (1 - xi) h^2/2: how far a parabola of unit curvature is from its chord.
double bubble(const Surface<2>& surface, const SurfaceFace<2>& face, const double xi) {
  const double length_square =
      surface.nodes[face.nodes[0]].position.distance_square(surface.nodes[face.nodes[1]].position);
  return 0.5 * xi * (1. - xi) * length_square;
}

OverlapPoint<2> overlap_point(const Surface<2>& source, const SurfaceFace<2>& source_face,
                              const double xi, const Surface<2>& target,
                              const SurfaceFace<2>& target_face, const double weight,
                              const MortarData<2>& data) {
  const Point<2> source_point =
      true_point(source, source_face, chord_point(source, source_face, xi));
  const double eta = project_on_face(target, target_face, source_point);
  const Point<2> target_point =
      true_point(target, target_face, chord_point(target, target_face, eta));
  const Tensor<1, 2> normal = face_normal(target, target_face, eta);
  const double relative_curvature = curvature(source, source_face) + curvature(target, target_face);
  const double missed = data.source_share * bubble(source, source_face, xi) +
                        (1. - data.source_share) * bubble(target, target_face, eta);
  return {{1. - xi, xi},
          {1. - eta, eta},
          target_face.nodes,
          data.along_source_normal ? -face_normal(source, source_face, xi) : normal,
          (source_point - target_point) * normal + relative_curvature * missed,
          weight};
}

}  // namespace

std::vector<OverlapPoint<2>> overlap_points(const Surface<2>& source,
                                            const SurfaceFace<2>& source_face,
                                            const FaceSearch<2>& search,
                                            const MortarData<2>& data) {
  const Surface<2>& target = search.target;
  static const dealii::QGauss<1> rule(4);
  const double length = source.nodes[source_face.nodes[0]].position.distance(
      source.nodes[source_face.nodes[1]].position);
  std::vector<OverlapPoint<2>> points;
  for (const Overlap& overlap : overlaps(source, source_face, target))
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double xi = overlap.begin + rule.point(q)[0] * (overlap.end - overlap.begin);
      const double weight = rule.weight(q) * (overlap.end - overlap.begin) * length *
                            data.measure(chord_point(source, source_face, xi));
      points.push_back(overlap_point(source, source_face, xi, target,
                                     target.faces[overlap.target_face], weight, data));
    }
  return points;
}

double face_weight(const Surface<2>& surface, const SurfaceFace<2>& face,
                   const MortarData<2>& data) {
  const double length =
      surface.nodes[face.nodes[0]].position.distance(surface.nodes[face.nodes[1]].position);
  return length * data.measure(chord_point(surface, face, 0.5));
}

}  // namespace geneva::fem
