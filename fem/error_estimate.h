#pragma once

#include <vector>

#include "fem/contact/active_set.h"

namespace geneva::fem {

/// Ratio of cell size to distance from the contact that suits a wanted accuracy, between 0 and 0.3.
double grading_for(double accuracy);

/// Relative error of the peak contact pressure: the greatest of
/// - its change from the mesh before, which bounds the remaining error since halving the edges
/// halves it at least;
/// - what the change before that leaves of an error now, lest two meshes agree by chance;
/// - what the contact's free ends are worth that lie somewhere on an edge;
/// plus what the cells around the contact are worth, whose ratio of size to distance stays the same
/// from mesh to mesh.
/// @param change relative change of the peak pressure from the mesh before
/// @param previous_error error of this mesh by the change one mesh earlier
/// @return between 0 and 1; 1 where the contact has too few nodes to say anything
template <int dim>
double error_estimate(double change, double previous_error, double grading,
                      const std::vector<ContactInterface<dim>>& interfaces);

/// Whether the peak pressures of successive meshes grow without bound, as they do where a contact
/// reaches a sharp edge.
/// @param history levels so far, the newest last
bool grows_without_bound(const std::vector<LevelRecord>& history);

/// What the pressures at the ends of a contact's length say of its edges: at a sharp one it is the
/// greatest of all, and grows from mesh to mesh by a power of the cells' fineness.
/// @param history levels so far, the newest last
EdgePressure edge_pressure(const std::vector<LevelRecord>& history);

}  // namespace geneva::fem
