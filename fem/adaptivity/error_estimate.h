#pragma once

#include <vector>

#include "fem/adaptivity/force_error.h"
#include "fem/adaptivity/level_record.h"
#include "fem/contact/interface.h"

namespace geneva::fem {

/// Maximum ratio of cell size to distance from the contact to begin with: coarse, since its part
/// in the error is measured and reduced where it matters. Only the cost depends on it.
template <int dim>
double first_grading(double accuracy);

/// By what a step that refines the cells around the contact multiplies that ratio.
template <int dim>
constexpr double grading_step = dim == 2 ? 0.5 : 0.7071;

/// A figure on one mesh, and what that mesh has finer than the one before.
struct MeshValue {
  double value;
  Refined refined;
  unsigned int halvings;     ///< of the contact's cells since the mesh before
  double size_measure;       ///< that the error by the cells' sizes is proportional to
  double energy_error = 0.;  ///< see there; 0: not known
};

/// Where a figure tends to on ever finer meshes; all relative to its value on the last one.
struct Extrapolation {
  double correction;          ///< to be added
  double zone_error;          ///< >= 0, of the resolution of the contact itself
  double surroundings_error;  ///< >= 0, what may be left of the correction
};

/// What is known beforehand of how the peak pressure converges.
struct Convergence {
  bool forces_are_given;  ///< whether it is known how great the contact's force is and where along
                          ///< its length it goes
  bool is_on_axis;  ///< of revolution: the nodes beside it are off, by a share of the order 1/N^2
  bool peaks_beside_end;             ///< see peaks_beside_end()
  bool is_peak_in_plane = false;     ///< the figure is the peak pressure of a contact in the plane
  bool is_freed_from_nodes = false;  ///< and as that of a line contact, see correct_for_nodes()
  double poissons_ratio = 0.;        ///< of that, see mean_poissons_ratio()
};

/// With fewer nodes across a contact the load still acts on a point: only the zone is refined.
constexpr unsigned int nodes_for_grading = 3;
/// With fewer nodes across a contact its pressure is of no use.
constexpr unsigned int fewest_active_nodes = 6;

/// Whether the meshes show what refinement of the zone leaves: in the plane if two of them have
/// enough nodes for a pressure of use, in 3-D, where meshes are dear, if the last one has.
/// @param history levels so far, the newest last
template <int dim>
bool shows_zone_error(const std::vector<LevelRecord>& history);

/// A pressure [Pa] on the meshes since the last one on which the load acted on a point.
/// @param history levels so far, the newest last
/// @param force where it is not given, the pressures are those under the true one
std::vector<MeshValue> resolved_values(const std::vector<LevelRecord>& history,
                                       double LevelRecord::*pressure, const ForcePower& force);

/// Richardson's extrapolation of the two parts of a figure's error, each from the changes over the
/// meshes that reduced it.
///
/// The zone's part is that of the order 1 to 2 that the last two changes show, and at least what
/// the older one leaves at second order, lest two meshes agree by chance. On an axis what the
/// last change leaves at second order is corrected. In the plane seven tenths of the peak
/// pressure's are kept where the changes show an order, a fifth where it is freed from the
/// nodes.
///
/// The part of the cells around the contact is proportional to their size measure: when that falls
/// from q to 1, the change is q - 1 times what is left, or less: changes fall faster than the
/// measure, since hanging faces and long cells go as well, or cells far away count less than
/// assumed. Three quarters are corrected where the forces are given, and three tenths stay in
/// doubt. Of a pressure that is freed from the nodes 0.56 of it and 0.01 times the square of the
/// grading are corrected; a fifth stays in doubt, and at least 0.016 times that square. Where
/// forces are not given, what is left lies between nothing and all, and the middle is taken. Where
/// the pressure peaks beside an end half is corrected and all stays in doubt.
/// @param values the newest last, all with enough nodes in contact
/// @param grading ratio of size to distance now
Extrapolation extrapolate(const std::vector<MeshValue>& values, double grading,
                          const Convergence& convergence);

/// Two parts together that know nothing of each other: the root of the sum of their squares, at
/// most 1.
double error_of(double one, double other);

/// What decides how well the pressure is known between nodes.
struct EndTraits {
  bool is_on_axis;           ///< the contact begins on an axis of revolution
  bool is_freed_from_nodes;  ///< the peak of a line contact, see correct_for_nodes()
};

/// Share of the peak pressure that is open because the free ends of the contacts lie somewhere on
/// an edge: 0.12/N^2 of line contacts with 7 nodes, 0.47/N^2 with fewer, where they peak beside an
/// end, and of rings, else 0.8/N^2. In the plane N is twice the number of nodes from the end to the
/// peak, less one, on an axis the nodes from it, in 3-D the nodes across; every run of nodes counts
/// as its pressure is to the maximum.
template <int dim>
double end_error(const std::vector<ContactInterface<dim>>& interfaces,
                 const std::vector<ContactState>& states, const EndTraits& traits);

/// Whether the maximum pressure stands much nearer to a free end than to the middle of its
/// contact, as where a flat becomes round: a third of the contact's nodes away from the end at
/// most.
template <int dim>
bool peaks_beside_end(const std::vector<ContactInterface<dim>>& interfaces,
                      const std::vector<ContactState>& states);

/// Whether any contact ends within the surfaces: others do not depend on the cells around them.
template <int dim>
bool has_free_ends(const std::vector<ContactInterface<dim>>& interfaces);

/// Whether the peak pressures of successive meshes grow without bound, as they do where a contact
/// reaches a sharp edge.
/// @param history levels so far, the newest last
bool grows_without_bound(const std::vector<LevelRecord>& history);

/// Whether neither the number of active nodes grew nor the peak pressure changed while the
/// contact's cells were halved three times.
/// @param history levels so far, the newest last
bool stands_still(const std::vector<LevelRecord>& history);

/// What the pressures at the ends of a contact's length say of its edges: at a sharp one it is the
/// maximum of all, and grows from mesh to mesh by a power of the cells' fineness.
/// @param history levels so far, the newest last
EdgePressure edge_pressure(const std::vector<LevelRecord>& history);

}  // namespace geneva::fem
