#pragma once

#include "fem/problem/problem.h"

namespace geneva::fem {

/// How a figure goes with the contact's force, as F to a power.
struct ForcePower {
  double power = 0.;  ///< 0: loads give the force, or the figure does not depend on it
  double doubt = 0.;  ///< by how much the power may be another one
};

/// Whether what the energy's error says of the force is used: in the plane, where supports that
/// move press the bodies and no load does. In 3-D the way along the length that the force takes
/// would have to be known, too.
template <int dim>
bool force_follows_from_energy(const Problem<dim>& problem) {
  return dim == 2 && is_pressed_by_supports(problem);
}

/// Whether it is known how great a contact's force is and where along its length it goes.
template <int dim>
bool force_is_known(const Problem<dim>& problem) {
  return dim == 2 && (!has_prescribed_displacement(problem) || is_pressed_by_supports(problem));
}

/// What tells a contact's pressure from Hertz's.
struct ContactShape {
  bool is_on_axis;        ///< of revolution: a point, not a line
  bool peaks_beside_end;  ///< see there
  bool has_free_ends;     ///< see there
};

/// p ~ F^(1/2) of a line contact, F^(1/3) of a point's (Johnson, Contact Mechanics, 4.2), F where
/// its size is given, between where a flat has round edges.
ForcePower force_of_peak(const ContactShape& contact);

/// Where supports that move press the bodies and no load does: by how much the force is too great,
/// relative, by what energy_error() says of the mesh.
///
/// That estimate is of all cells; those at the contact, whose stresses are less smooth, it takes
/// for worse than they are. On random line contacts and spheres with at least 12 nodes in contact
/// the force was too great by 0.56 to 1.0 times the estimate.
constexpr double force_excess(const double energy_error) { return 0.8 * energy_error; }
constexpr double force_doubt(const double energy_error) { return 0.25 * energy_error; }

/// A figure under the force that finer meshes tend to.
/// @param value on a mesh
/// @param energy_error of that mesh, >= 0
double under_true_force(double value, double energy_error, const ForcePower& force);

/// What stays open of it because the force does, relative.
double open_by_force(double energy_error, const ForcePower& force);

}  // namespace geneva::fem
