#pragma once

#include <array>
#include <vector>

#include "post/analysis/results.h"

namespace geneva::post {

/// Scalars at the points of a view, by their names in `view_fields`.
constexpr std::array<const char*, 6> view_fields{"von_mises",          "max_shear",
                                                 "principal_stress_1", "principal_stress_2",
                                                 "principal_stress_3", "mcewen_difference"};

/// Triangles that are looked at; SI units.
struct ViewMesh {
  std::vector<double> points;        ///< x, y, z of each point, undeformed [m]
  std::vector<float> displacements;  ///< three of each point [m]
  std::vector<unsigned int> bodies;  ///< of each point, an index into Problem::bodies
  std::array<std::vector<float>, view_fields.size()> fields;  ///< [Pa]; not a number: there is none
  std::vector<unsigned int> triangles;                        ///< three points of each triangle
  std::vector<unsigned int> outlines;  ///< two points of each line that bounds the bodies, in 3-D
                                       ///< of each of their edges
};

/// Visualisation data of a solution: in the plane all cells, in 3-D the boundary of the bodies. On
/// rank 0; all ranks take part.
template <int dim>
ViewMesh visible_mesh(const fem::Solution<dim>& solution, const Results<dim>& results);

/// A plane through a point [m].
struct CutPlane {
  dealii::Point<3> point;
  dealii::Tensor<1, 3> normal;
};

/// The bodies cut by a plane. On rank 0; all ranks take part.
ViewMesh cut_mesh(const fem::Solution<3>& solution, const Results<3>& results,
                  const CutPlane& plane);

}  // namespace geneva::post
