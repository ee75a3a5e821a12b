#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <optional>
#include <utility>
#include <vector>

#include "fem/adaptivity/refinement_zone.h"
#include "fem/contact/interface.h"
#include "fem/discretisation/vector.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// What is to be refined.
struct Wanted {
  bool zone;  ///< the contact zones; else only the cells around them
  /// Maximum ratio of a cell's size to its distance from the contact, see size_growth(). Nothing
  /// while the contact is not resolved well enough for sizes and energy norm to make sense:
  /// then only the zones are refined.
  std::optional<double> grading;
  double growth;          ///< see size_growth()
  bool by_energy = true;  ///< of the cells around alone
};

/// Flags the cells to refine: evenly those along every contact zone, so that the contact pressure
/// lives on a smooth mesh; those that are large for their distance from it; and those with a large
/// energy-norm error (Kelly et al. 1983).
/// @param surface_ids boundary ids (source, target) of the interfaces
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_cells(dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                        const std::vector<ContactInterface<dim>>& interfaces,
                        const SurfaceIds& surface_ids, const Wanted& wanted);

/// The power m of the distance in size_measure().
///
/// A linear cell is off by h^2 times the second derivatives of the displacement, and that counts as
/// much as those of the dual solution of the peak pressure. Under a line load the former fall as
/// 1/r^2. In the plane, where the force of a contact is known, what is left of the dual solution
/// is a double couple, with b^2/r^4: m = 6; around an axis 1/r^3, b^2/r^5 and cells of the volume
/// r dA: m = 7. Under loads and a prescribed displacement together the cells decide how great the
/// force is, in 3-D where along the length it goes, and the dual solution is a force: m is less by
/// 2.
template <int dim>
int size_decay(const Problem<dim>& problem);

/// Power of the distance that sizes of cells grow with, farther than two widths of the contact
/// away.
///
/// The minimum number of cells for an error of the sum of h^2 V/r^m, in the plane with a number of
/// V/h^2, has h in proportion to r^(m/4): 1.5 where loads give the contact's force, and 1 under a
/// prescribed displacement, where cells far away decide how great it is. In 3-D 1.
template <int dim>
double size_growth(const Problem<dim>& problem);

/// What the error of the peak pressure that comes from the cells around the contacts is
/// proportional to: the sum over those larger than the contact's edges next to them of h^2 V/max(r,
/// b)^m, h being the size, r the distance from the nearest node in contact and b half of the zone's
/// width.
/// @param decay m, see size_decay()
template <int dim>
double size_measure(dealii::DoFHandler<dim>& dof_handler,
                    const std::vector<ContactInterface<dim>>& interfaces,
                    const SurfaceIds& surface_ids, int decay);

/// Flags a part of the cells along the contact zones: the contact pressure ripples where edges
/// change their length.
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_zone_part(dealii::DoFHandler<dim>& dof_handler,
                            const std::vector<ContactInterface<dim>>& interfaces,
                            const SurfaceIds& surface_ids, ZonePart part);

/// The longest edge of a contact zone over its shortest one, on both sides together; the maximum
/// of all zones.
double unevenness(const std::vector<ContactInterface<2>>& interfaces);

}  // namespace geneva::fem
