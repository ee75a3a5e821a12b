#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <array>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "fem/contact/contact_law.h"
#include "fem/contact/contact_result.h"
#include "fem/contact/mortar.h"
#include "fem/elasticity/surface_forces.h"
#include "fem/linear/constraints.h"

namespace geneva::fem {

/// From and to, of arc length on a surface.
using ArcIntervals = std::vector<std::pair<double, double>>;

/// One contact pair on one mesh, the same on every rank.
template <int dim>
struct ContactInterface {
  Surface<dim> source;
  Surface<dim> target;
  std::vector<ContactRow<dim>> rows;
  std::vector<NodeStatus> status;  ///< by row
  ArcIntervals smooth = {};  ///< of the source, in the plane: there the edges are short enough
  dealii::Tensor<1, dim> approach = {};  ///< unit vector along which loads push the source to the
                                         ///< target; 0 if not known
  std::shared_ptr<const ContactLaw<dim>> law = std::make_shared<const Frictionless<dim>>();
};

/// Along the tangents of a frame; in the plane the second is 0.
using Tangential = std::array<double, 2>;

/// What is at the source nodes, by row.
struct ContactState {
  std::vector<double> pressure;           ///< >= 0 in compression
  std::vector<double> gap;                ///< > 0 when open
  double approach = 0.;                   ///< greatest change of a gap by the displacement
  std::vector<Tangential> slip = {};      ///< of the source against the target
  std::vector<Tangential> friction = {};  ///< traction on the source
};

/// The rows that touch first: those whose initial gap along the approach is the smallest. Where a
/// pin fits the bottom of its slot, gaps across the approach are small, too, but never close.
template <int dim>
std::vector<NodeStatus> first_touch(const ContactInterface<dim>& interface);

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

/// The active rows but those where the pressure is smooth: the zone whose resolution decides.
template <int dim>
std::vector<bool> zone_rows(const ContactInterface<dim>& interface);

/// Which nodes of the source belong to the zone.
template <int dim>
std::vector<bool> zone_nodes(const ContactInterface<dim>& interface);

/// Where nodes lie so close that the pressure between the neighbours of each is off the straight
/// line by a small share of the peak at most, so that finer edges would change nothing: the middle
/// of a wide contact whose pressure peaks at its ends. None if that is the whole contact, or less
/// than three quarters of it.
/// @param tolerance that share, > 0
ArcIntervals smooth_intervals(const ContactInterface<2>& interface, const ContactState& state,
                              double tolerance);

/// Whether the greatest pressure stands within four edges of an end or a corner of the source, or
/// over one of the target.
bool peaks_at_corner(const ContactInterface<2>& interface, const ContactState& state);

/// How many active nodes the contact is wide: all of them in the plane; in 3-D twice the most
/// steps from an active node to an open one, less one.
unsigned int nodes_across(const ContactInterface<2>& interface);
unsigned int nodes_across(const ContactInterface<3>& interface);

/// Arc-length intervals of the source surface covered by the nodes of the zone.
ArcIntervals zone_intervals(const ContactInterface<2>& interface);

/// The equations of the pair's law that are constraints, such as gap_j(u) = 0, solved for the
/// displacement component with the greatest share of their direction that no support holds. Those
/// whose components are all held are left out.
/// @param held dofs that supports, ties or other contact pairs already constrain; the lines' dofs
/// are added
template <int dim>
std::vector<ConstraintLine> contact_lines(const ContactInterface<dim>& interface,
                                          std::set<global_dof_index>& held);

/// Gap and slip from the displacement; pressure and friction from the forces K u - f, divided by D
/// (no differentiation).
/// @param held dofs whose forces hold reactions of supports
template <int dim>
ContactState evaluate(const ContactInterface<dim>& interface,
                      const dealii::TrilinosWrappers::MPI::Vector& displacement,
                      const SurfaceForces& forces, const std::set<global_dof_index>& held);

/// The status that the pair's law gives every node next.
template <int dim>
std::vector<NodeStatus> updated(const ContactInterface<dim>& interface, const ContactState& state);

}  // namespace geneva::fem
