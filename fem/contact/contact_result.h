#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "fem/contact/node_status.h"
#include "fem/problem/moment.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// Along the two surfaces that meet, tension positive.
struct SurfaceStrain {
  double source = 0.;
  double target = 0.;
};

/// A source node of a contact pair, SI units.
template <int dim>
struct ContactNode {
  double arc_length;         ///< along the source surface [m]; in the plane
  Components<dim> position;  ///< undeformed [m]
  Components<dim> normal;    ///< unit, from the target to the source
  double pressure;           ///< >= 0 [Pa]
  double gap;                ///< > 0 when open [m]
  double initial_gap;        ///< before loading [m]
  double tributary;          ///< D_j: the area that the node stands for [m^2]
  NodeStatus status;
  Components<dim> friction{};  ///< traction on the source along the surface [Pa]
  Components<dim> slip{};      ///< of the source against the target along the surface [m]
  SurfaceStrain strain = {};   ///< in the plane
};

/// A stretch of the source surface in contact, by its arc lengths [m].
struct ContactInterval {
  double begin;
  double end;
  bool
      symmetric;  ///< one end is a plane or axis of symmetry of the model: the pressure peaks there

  [[nodiscard]] double half_width() const { return symmetric ? end - begin : (end - begin) / 2.; }
};

/// What one contact pair carries, SI units.
template <int dim>
struct ContactResult {
  std::string source;
  std::string target;
  std::vector<ContactNode<dim>> nodes;  ///< in the plane in the order of the arc length
  /// Faces (indices into nodes) of the source whose nodes all face the target; in 3-D.
  std::vector<std::array<std::size_t, 4>> faces;
  Components<dim> force;  ///< resultant of the pressure on the source body [N]
  /// Resultant of the friction on the source body [N], without what a mirror image cancels.
  Components<dim> friction_force{};
  /// What the pressure adds up to along the normals of planes of symmetry, or along the radius of a
  /// body of revolution, and what is balanced there [N]; not in `force`
  Components<dim> lateral_force;
  Moment<dim> moment;  ///< of the pressure on the source body about the origin [N m]
  /// [Pa]; that of the nodes with what the cells around the contact are worth, see
  /// Solution::correction
  double peak_pressure;
  std::vector<ContactInterval> intervals;  ///< in the plane
  double half_width;       ///< of the interval with the peak pressure, in the plane [m]
  bool symmetric;          ///< whether that one ends at a plane or axis of symmetry
  double max_penetration;  ///< maximum overlap left between inactive nodes [m]
  unsigned int active_nodes;
  int source_circle;      ///< circle of the source surface where the pressure peaks; -1: straight
  int target_circle;      ///< the same of the target
  bool source_is_convex;  ///< the source's circle bulges outwards
  bool target_is_convex;
  bool has_one_curvature;  ///< whether each surface has the same one throughout the contact
};

}  // namespace geneva::fem
