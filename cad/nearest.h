#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <vector>

namespace geneva::cad {

/// Which of some shapes are nearest to a place.
struct Nearest {
  std::vector<std::size_t> shapes;  ///< indices; more than one if they are equally near
  double distance;                  ///< to their points, not to what they are parts of
};

/// @param shapes one at least
/// @param place in the shapes' unit of length, as are all lengths here
/// @param rounding distances that differ by less are equal, > 0
Nearest nearest(const std::vector<TopoDS_Shape>& shapes, const std::array<double, 3>& place,
                double rounding);

/// Diagonal of the box around shapes.
double extent(const std::vector<TopoDS_Shape>& shapes);

/// Volume of a solid, area of a face, length of an edge, and the middle of it.
struct Measure {
  double size;
  std::array<double, 3> middle;
};
Measure measure(const TopoDS_Shape& shape);

}  // namespace geneva::cad
