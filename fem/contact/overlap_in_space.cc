#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "fem/contact/overlap.h"
#include "fem/contact/surface_in_space.h"

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Overlaps smaller than this share of the source face are round-off.
constexpr double minimum_share = 1e-12;

/// Faces can touch only if their outward normals are opposed by more than this cosine. Where a face
/// reaches past the silhouette of a round target, the faces there stand almost upright on it: along
/// their normals the gap looks small. Coarse faces that belong together are 45 degrees off at most,
/// with two of them in a quarter.
constexpr double opposed_in_space = -0.5;

using Polygon = std::vector<Point<2>>;

double area(const Polygon& polygon) {
  double sum = 0.;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]) / 2.;
  return sum;
}

/// The plane of a source face, with coordinates in it; the third direction leads outwards.
class AuxiliaryPlane {
 public:
  AuxiliaryPlane(const Surface<3>& surface, const SurfaceFace<3>& face)
      : origin_(face_middle(surface, face)), normal_(flat_normal(surface, face)) {
    const Tensor<1, 3> edge =
        surface.nodes[face.nodes[1]].position - surface.nodes[face.nodes[0]].position;
    first_ = edge - (edge * normal_) * normal_;
    first_ /= first_.norm();
    second_ = dealii::cross_product_3d(normal_, first_);
  }

  [[nodiscard]] Point<2> project(const Point<3>& point) const {
    return {(point - origin_) * first_, (point - origin_) * second_};
  }
  [[nodiscard]] Polygon project(const Surface<3>& surface, const SurfaceFace<3>& face) const {
    Polygon polygon;
    polygon.reserve(face.nodes.size());
    for (const unsigned int node : face.nodes)
      polygon.push_back(project(surface.nodes[node].position));
    return polygon;
  }
  [[nodiscard]] double height(const Point<3>& point) const { return (point - origin_) * normal_; }
  [[nodiscard]] const Tensor<1, 3>& normal() const { return normal_; }

 private:
  Point<3> origin_;
  Tensor<1, 3> normal_;
  Tensor<1, 3> first_;
  Tensor<1, 3> second_;
};

/// The part of a polygon to the left of a straight line (Sutherland and Hodgman 1974).
Polygon left_of(const Polygon& polygon, const Point<2>& start, const Point<2>& end) {
  Polygon result;
  result.reserve(polygon.size() + 1);  // of a convex one at most
  const auto side = [&](const Point<2>& point) { return cross(end - start, point - start); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<2>& here = polygon[i];
    const Point<2>& next = polygon[(i + 1) % polygon.size()];
    const double from = side(here);
    const double to = side(next);
    if (from >= 0.) result.push_back(here);
    if ((from > 0. && to < 0.) || (from < 0. && to > 0.))
      result.push_back(here + from / (from - to) * (next - here));
  }
  return result;
}

/// Intersection of two convex polygons, both counter-clockwise.
Polygon intersection(const Polygon& one, Polygon other) {
  for (std::size_t i = 0; i < one.size() && other.size() > 2; ++i)
    other = left_of(other, one[i], one[(i + 1) % one.size()]);
  return other;
}

/// Where in a quadrilateral of the plane a point is: Newton's method on the bilinear map.
std::array<double, 2> inverse_bilinear(const Polygon& corners, const Point<2>& point) {
  std::array<double, 2> at{0.5, 0.5};
  for (unsigned int step = 0; step < 20; ++step) {
    const auto shapes = bilinear_shapes(at);
    Tensor<1, 2> residual = point;
    for (std::size_t i = 0; i < 4; ++i) residual -= shapes[i] * Tensor<1, 2>(corners[i]);
    const Tensor<1, 2> along =
        (1. - at[1]) * (corners[1] - corners[0]) + at[1] * (corners[2] - corners[3]);
    const Tensor<1, 2> across =
        (1. - at[0]) * (corners[3] - corners[0]) + at[0] * (corners[2] - corners[1]);
    const double determinant = cross(along, across);
    const double first = cross(residual, across) / determinant;
    const double second = cross(along, residual) / determinant;
    at[0] += first;
    at[1] += second;
    if (std::abs(first) + std::abs(second) < 1e-15) break;
  }
  return at;
}

/// What a bilinear displacement misses of a motion that takes up the relative curvature of both
/// surfaces: the parts u'' xi (1 - xi) h^2/2 along both directions of a face.
double missed(const Surface<3>& source, const SurfaceFace<3>& source_face, const Surface<3>& target,
              const SurfaceFace<3>& target_face, const SurfaceFace<3>& meshed,
              const Surface<3>& mesh, const std::array<double, 2>& at) {
  double sum = 0.;
  for (const std::size_t direction : {0U, 1U}) {
    const Tensor<1, 3> edge = face_edge(mesh, meshed, direction);
    sum += 0.5 * at[direction] * (1. - at[direction]) *
           (bulge(source, source_face, edge) + bulge(target, target_face, edge));
  }
  return sum;
}

OverlapPoint<3> overlap_point(const Surface<3>& source, const SurfaceFace<3>& source_face,
                              const std::array<double, 2>& xi, const Surface<3>& target,
                              const SurfaceFace<3>& target_face, const std::array<double, 2>& eta,
                              const double weight, const MortarData<3>& data) {
  const Point<3> source_point =
      true_point(source, source_face, face_point(source, source_face, xi));
  const Point<3> target_point =
      true_point(target, target_face, face_point(target, target_face, eta));
  const Tensor<1, 3> normal = face_normal(target, target_face, eta);
  const double of_source =
      missed(source, source_face, target, target_face, source_face, source, xi);
  const double of_target =
      missed(source, source_face, target, target_face, target_face, target, eta);
  return {bilinear_shapes(xi),
          bilinear_shapes(eta),
          target_face.nodes,
          data.along_source_normal ? -face_normal(source, source_face, xi) : normal,
          (source_point - target_point) * normal + data.source_share * of_source +
              (1. - data.source_share) * of_target +
              (data.clearance ? data.clearance(source_point[2]) : 0.),
          weight};
}

/// Where a source face and a target face lie over each other, in the source face's plane.
/// @param polygon the target face's projection
std::optional<Polygon> overlap(const AuxiliaryPlane& plane, const Polygon& source_polygon,
                               const Surface<3>& target, const SurfaceFace<3>& face,
                               Polygon polygon) {
  if (plane.normal() * flat_normal(target, face) > opposed_in_space) return std::nullopt;
  // An overlap of a quarter of the surface is no interference: it is the body's far side.
  if (plane.height(face_middle(target, face)) < -0.25 * target.length) return std::nullopt;
  std::reverse(polygon.begin(), polygon.end());
  polygon = intersection(source_polygon, polygon);
  if (polygon.size() < 3 || area(polygon) < minimum_share * area(source_polygon))
    return std::nullopt;
  return polygon;
}

}  // namespace

FaceSearch<3>::Ball FaceSearch<3>::ball_around(const Surface<3>& surface,
                                               const SurfaceFace<3>& face) {
  Ball ball{face_middle(surface, face), 0.};
  for (const unsigned int node : face.nodes)
    ball.radius = std::max(ball.radius, ball.middle.distance(surface.nodes[node].position));
  return ball;
}

FaceSearch<3>::FaceSearch(const Surface<3>& surface) : target(surface) {
  std::vector<std::pair<dealii::BoundingBox<3>, unsigned int>> boxes;
  for (unsigned int face = 0; face < target.faces.size(); ++face) {
    std::vector<Point<3>> corners;
    for (const unsigned int node : target.faces[face].nodes)
      corners.push_back(target.nodes[node].position);
    boxes.emplace_back(dealii::BoundingBox<3>(corners), face);
    balls_.push_back(ball_around(target, target.faces[face]));
  }
  tree_ = dealii::pack_rtree(boxes);
}

std::vector<unsigned int> FaceSearch<3>::near(const Surface<3>& source,
                                              const SurfaceFace<3>& face) const {
  const Tensor<1, 3> normal = flat_normal(source, face);
  std::vector<Point<3>> corners;
  for (const unsigned int node : face.nodes)
    for (const double side : {-1., 1.})
      corners.push_back(source.nodes[node].position + side * target.length * normal);
  const Ball around = ball_around(source, face);
  const auto is_near = [&](const unsigned int index) {
    const Tensor<1, 3> apart = balls_[index].middle - around.middle;
    const double along = apart * normal;
    const double reach = around.radius + balls_[index].radius;
    return apart.norm_square() - along * along <= reach * reach;
  };
  std::vector<unsigned int> faces;
  const auto meets = boost::geometry::index::intersects(dealii::BoundingBox<3>(corners));
  for (auto found = tree_.qbegin(meets); found != tree_.qend(); ++found)
    if (is_near(found->second)) faces.push_back(found->second);
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<OverlapPoint<3>> overlap_points(const Surface<3>& source, const SurfaceFace<3>& face,
                                            const FaceSearch<3>& search,
                                            const MortarData<3>& data) {
  const Surface<3>& target = search.target;
  static const dealii::QGaussSimplex<2> rule(3);  // exact to degree 5
  const AuxiliaryPlane plane(source, face);
  const Polygon source_polygon = plane.project(source, face);
  std::vector<OverlapPoint<3>> points;
  for (const unsigned int index : search.near(source, face)) {
    const SurfaceFace<3>& target_face = target.faces[index];
    const Polygon target_polygon = plane.project(target, target_face);
    const auto polygon = overlap(plane, source_polygon, target, target_face, target_polygon);
    if (!polygon) continue;
    for (std::size_t i = 1; i + 1 < polygon->size(); ++i) {
      const Tensor<1, 2> first = (*polygon)[i] - (*polygon)[0];
      const Tensor<1, 2> second = (*polygon)[i + 1] - (*polygon)[0];
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const Point<2> at = (*polygon)[0] + rule.point(q)[0] * first + rule.point(q)[1] * second;
        const std::array<double, 2> xi = inverse_bilinear(source_polygon, at);
        const std::array<double, 2> eta = inverse_bilinear(target_polygon, at);
        const double weight =
            rule.weight(q) * cross(first, second) * data.measure(face_point(source, face, xi));
        points.push_back(overlap_point(source, face, xi, target, target_face, eta, weight, data));
      }
    }
  }
  return points;
}

double face_weight(const Surface<3>& surface, const SurfaceFace<3>& face,
                   const MortarData<3>& data) {
  const AuxiliaryPlane plane(surface, face);
  return area(plane.project(surface, face)) * data.measure(face_middle(surface, face));
}

}  // namespace geneva::fem
