#pragma once

#include <vector>

#include "fem/contact/surface.h"

namespace geneva::fem {

/// Outward unit normal at eta in [0, 1] of an edge: the nodes' normals interpolated, which is the
/// true normal on a circle and on a straight line.
dealii::Tensor<1, 2> face_normal(const Surface<2>& surface, const SurfaceFace<2>& face, double eta);

/// The eta of the edge's point from which the interpolated normal leads to the given point.
double project_on_face(const Surface<2>& surface, const SurfaceFace<2>& face,
                       const dealii::Point<2>& point);

/// The part begin..end of a source edge (in [0, 1]) that lies over one target edge.
struct Overlap {
  double begin;
  double end;
  unsigned int target_face;
};

/// The overlaps of a source edge with the target's edges that look at it, in order along the edge
/// and disjoint.
std::vector<Overlap> overlaps(const Surface<2>& source, const SurfaceFace<2>& source_face,
                              const Surface<2>& target);

}  // namespace geneva::fem
