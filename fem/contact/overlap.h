#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "fem/contact/surface.h"

namespace geneva::fem {

/// What the integrals along a contact pair need beside its two surfaces.
template <int dim>
struct MortarData {
  std::function<double(const dealii::Point<dim>&)> measure;  ///< out-of-plane measure at a point
  double source_share;  ///< of the source body in the compliance of both, 0..1
  std::function<double(double)> clearance = {};  ///< added to the gap by z, in 3-D; may be empty
  MPI_Comm communicator = MPI_COMM_SELF;         ///< ranks that share the work; all get the result
  bool along_source_normal = false;  ///< the bodies press on each other along it, not the target's
};

/// Nodes of a face.
template <int dim>
constexpr std::size_t n_face_nodes = 1U << (dim - 1);

/// A quadrature point on the overlap of a source and a target face.
template <int dim>
struct OverlapPoint {
  std::array<double, n_face_nodes<dim>> source_shapes;
  std::array<double, n_face_nodes<dim>> target_shapes;
  std::array<unsigned int, n_face_nodes<dim>> target_nodes;
  dealii::Tensor<1, dim> normal;  ///< from the target to the source
  double gap;                     ///< of the true surfaces, with what linear displacements miss
  double weight;                  ///< share of the source face's area, times the measure
};

/// Finds the target faces that may lie over a source face.
template <int dim>
class FaceSearch;

/// In the plane there are few: all of them.
template <>
class FaceSearch<2> {
 public:
  explicit FaceSearch(const Surface<2>& surface) : target(surface) {}

  const Surface<2>& target;
};

/// In 3-D by a tree of the boxes around the target faces.
template <>
class FaceSearch<3> {
 public:
  explicit FaceSearch(const Surface<3>& surface);

  /// Indices in ascending order of the target faces that come near a source face extruded along
  /// its normal to both sides by the target's length: their boxes meet, and the ball around the
  /// target face meets the cylinder around the other.
  [[nodiscard]] std::vector<unsigned int> near(const Surface<3>& source,
                                               const SurfaceFace<3>& face) const;

  const Surface<3>& target;

 private:
  struct Ball {
    dealii::Point<3> middle;
    double radius;
  };
  static Ball ball_around(const Surface<3>& surface, const SurfaceFace<3>& face);

  std::vector<Ball> balls_;  ///< around the target faces
  dealii::RTree<std::pair<dealii::BoundingBox<3>, unsigned int>> tree_;
};

/// Gauss points on all overlaps of one source face with the target. In the plane the source edge is
/// split where target nodes project on it; in 3-D both faces are projected on the source face's
/// plane and cut with each other (Puso and Laursen 2004).
std::vector<OverlapPoint<2>> overlap_points(const Surface<2>& source, const SurfaceFace<2>& face,
                                            const FaceSearch<2>& search, const MortarData<2>& data);
std::vector<OverlapPoint<3>> overlap_points(const Surface<3>& source, const SurfaceFace<3>& face,
                                            const FaceSearch<3>& search, const MortarData<3>& data);

/// The whole face's area (length of the chord in the plane) times the measure at its middle.
double face_weight(const Surface<2>& surface, const SurfaceFace<2>& face,
                   const MortarData<2>& data);
double face_weight(const Surface<3>& surface, const SurfaceFace<3>& face,
                   const MortarData<3>& data);

}  // namespace geneva::fem
