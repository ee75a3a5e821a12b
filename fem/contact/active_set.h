#pragma once

#include <deal.II/base/point.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "fem/contact/contact_result.h"
#include "fem/contact/interface.h"

namespace geneva::fem {

/// The rows that touch first: those whose initial gap along the approach is the smallest. Where a
/// pin fits the bottom of its slot, gaps across the approach are small, too, but never close.
template <int dim>
std::vector<NodeStatus> first_touch(const ContactInterface<dim>& interface);

/// Whether loads pull the source away from the target where the two are nearest, and close no gap
/// that is small beside the surface.
template <int dim>
bool is_pulled_apart(const ContactInterface<dim>& interface);

/// The open row that touches first where the source moves on along a unit vector; nothing if none
/// lies ahead.
template <int dim>
std::optional<std::size_t> first_ahead(const ContactInterface<dim>& interface,
                                       const ContactState& state,
                                       const dealii::Tensor<1, dim>& direction);

/// The rows within the contact that the coarser mesh found, or first_touch if there is none.
/// @param intervals of the coarser mesh's contact [m]
/// @param length unit of length of the triangulation [m]
std::vector<NodeStatus> inherited(const ContactInterface<2>& interface,
                                  const std::vector<ContactInterval>& intervals, double length);

/// In 3-D: the rows whose nodes are nearest to an active node of the coarser mesh, and not as
/// near to one that is not active.
/// @param nodes of the coarser mesh's result [m]
std::vector<NodeStatus> inherited(const ContactInterface<3>& interface,
                                  const std::vector<ContactNode<3>>& nodes, double length);

/// How the nodes of the rows move.
template <int dim>
std::vector<NodeMotion<dim>> motions_of(const ContactInterface<dim>& interface);

/// Lets rows in contact stick or slide as the nearest node did on another mesh, of a law that knows
/// both: found again from nodes that all stick, what slides far would take many steps or none.
template <int dim>
void recall(ContactInterface<dim>& interface, const std::vector<NodeMotion<dim>>& motions);

/// Places of the active rows' nodes.
template <int dim>
std::vector<dealii::Point<dim>> active_places(const ContactInterface<dim>& interface);

/// The rows whose nodes stand at the places that active_places() gave on the same mesh.
/// @throws base::InputError if a place has none
template <int dim>
std::vector<NodeStatus> active_at(const ContactInterface<dim>& interface,
                                  const std::vector<dealii::Point<dim>>& places);

/// Which nodes of the source belong to active rows.
template <int dim>
std::vector<bool> active_nodes(const ContactInterface<dim>& interface);

/// The status that the pair's law gives every node next.
template <int dim>
std::vector<NodeStatus> updated(const ContactInterface<dim>& interface, const ContactState& state);

/// The directions of sliding that the pair's law gives the nodes next.
template <int dim>
std::vector<Components<dim>> next_sliding(const ContactInterface<dim>& interface,
                                          const ContactState& state);

}  // namespace geneva::fem
