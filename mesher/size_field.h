#pragma once

#include <vector>

#include "loads/wheel/outline.h"
#include "mesh/outline_mesh.h"

namespace geneva::mesher {

using mesh::MeshSizing;

/// Sense and extent of an arc: angle [rad] from its start to its end, positive counter-clockwise,
/// below half a turn.
double arc_angle(const loads::Segment& segment);

/// Length of a line or arc, in the unit of its coordinates.
double length_of(const loads::Segment& segment);

/// Point of a segment, t from 0 at its start to 1 at its end, evenly along its length.
loads::Point point_of(const loads::Segment& segment, double t);

/// Fewest cells along a segment: one, and on an arc one per 45 degrees.
int minimum_cells(const loads::Segment& segment);

/// Cell size as a function of place.
///
/// h(x) = min(general, at_contact + slope |x - contact|, min over the fine places (their size +
/// growth * distance)). Fine places are segments too short or too strongly curved for the general
/// size, and points of the boundary from which it is not far to another part of it.
class SizeField {
 public:
  SizeField(const std::vector<loads::Outline>& outlines, const MeshSizing& sizing);

  [[nodiscard]] double operator()(loads::Point place) const;

  /// Number of cells along a segment (the integral of 1/h), as a fraction, up to each of evenly
  /// spaced places.
  /// @return at t = 0, 1/(size - 1), ... 1; increasing from 0
  [[nodiscard]] std::vector<double> cells_along(const loads::Segment& segment) const;

 private:
  /// A segment with what makes distances to it quick.
  struct Shape {
    loads::Segment segment;
    loads::Point middle;    ///< of a circle around the segment
    double reach;           ///< radius of that circle
    loads::Point towards;   ///< arc: unit vector from the centre to its middle
    double minimum_cosine;  ///< arc: of the angle from `towards` to its ends
    double radius;          ///< arc
  };
  struct FinePlace {
    Shape shape;
    double size;
  };

  static Shape shape_of(const loads::Segment& segment);
  static double distance(const Shape& shape, loads::Point place);
  static bool is_beyond(const Shape& shape, loads::Point place, double distance);
  void add_fine_segments(const std::vector<Shape>& shapes);
  void add_narrow_places(const std::vector<Shape>& shapes);

  MeshSizing sizing_;
  std::vector<FinePlace> fine_places_;  ///< smallest size first
};

}  // namespace geneva::mesher
