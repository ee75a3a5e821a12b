#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/trilinos_vector.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/contact/node_status.h"
#include "fem/moment.h"
#include "fem/problem.h"
#include "fem/scaling.h"
#include "fem/stop.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// A source node of a contact pair, SI units.
template <int dim>
struct ContactNode {
  double arc_length;         ///< along the source surface [m]; in the plane
  Components<dim> position;  ///< undeformed [m]
  Components<dim> normal;    ///< target's outward unit normal
  double pressure;           ///< >= 0 [Pa]
  double gap;                ///< > 0 when open [m]
  double initial_gap;        ///< before loading [m]
  double tributary;          ///< D_j: the area that the node stands for [m^2]
  NodeStatus status;
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
  /// What the pressure adds up to along the normals of planes of symmetry, or along the radius of a
  /// body of revolution, and what is balanced there [N]; not in `force`
  Components<dim> lateral_force;
  Moment<dim> moment;  ///< of the pressure on the source body about the origin [N m]
  /// [Pa]; that of the nodes with what the cells around the contact are worth, see
  /// Solution::correction
  double peak_pressure;
  std::vector<ContactInterval> intervals;  ///< in the plane
  double half_width;                       ///< of the widest interval, in the plane [m]
  bool symmetric;                          ///< whether that one ends at a plane or axis of symmetry
  double max_penetration;                  ///< greatest overlap left between inactive nodes [m]
  unsigned int active_nodes;
  int source_circle;      ///< circle of the source surface where the pressure peaks; -1: straight
  int target_circle;      ///< the same of the target
  bool source_is_convex;  ///< the source's circle bulges outwards
  bool target_is_convex;
  bool has_one_curvature;  ///< whether each surface has the same one throughout the contact
};

/// Reaction of a support or rigid tie: force [N] and moment about the origin [N m] that it exerts
/// on its body.
template <int dim>
struct Reaction {
  std::string surface;
  Components<dim> force{};
  Moment<dim> moment{};
};

/// What a mesh has finer than the one before.
enum class Refined {
  nothing,      ///< the first mesh
  zone,         ///< the contact zone; the cells around keep their ratio of size to distance
  surroundings  ///< the cells around the contact, whose ratio of size to distance is halved
};

/// One mesh of the nested iteration.
struct LevelRecord {
  unsigned int cells;
  unsigned int dofs;
  std::vector<unsigned int> linear_iterations;  ///< one entry for every active-set step
  double peak_pressure;                         ///< [Pa]
  Refined refined;
  double grading;         ///< greatest ratio of cell size to distance from the contact
  double size_measure;    ///< see there; of the error by the cells' sizes
  double error_estimate;  ///< relative, of the peak pressure extrapolated from this mesh
  /// In 3-D: greatest pressure in the middle half of the surfaces' common length, and at its two
  /// ends [Pa].
  double mid_length_pressure;
  double end_pressure;
  unsigned int halvings;  ///< of the contact's cells since the mesh before
  unsigned int active_nodes;
  unsigned int nodes_across;  ///< active nodes that the contacts are wide
  bool cycled;     ///< the active set came back to an earlier one; its nodes then could only close
  double seconds;  ///< since the start of the contact solve
  double one_solve_seconds;  ///< one assembly and one linear solve on this mesh
};

/// Pressure at the ends of a contact's length.
struct EdgePressure {
  bool is_bounded;
  double
      growth_exponent;  ///< gamma of p ~ h^-gamma over the last two meshes, h being the cell size
  double pressure;      ///< greatest beyond the middle half of the length [Pa]
};

/// The converged elastic state; the mesh and the displacement are in the units of `scales`.
template <int dim>
struct Solution {
  Problem<dim> problem;  ///< SI units
  Scales scales{};
  mesh::MeshData<dim> mesh;  ///< coarse, SI units
  std::shared_ptr<const dealii::parallel::distributed::Triangulation<dim>> triangulation;
  std::shared_ptr<const dealii::FESystem<dim>> element;
  std::shared_ptr<const dealii::DoFHandler<dim>> dof_handler;
  dealii::TrilinosWrappers::MPI::Vector displacement;  ///< ghosted

  std::vector<ContactResult<dim>> contacts;
  std::vector<Reaction<dim>> reactions;  ///< of supports, then ties
  Components<dim> applied_force{};       ///< of body forces and surface loads [N]
  Moment<dim> applied_moment{};          ///< about the origin [N m]
  std::vector<LevelRecord> history;
  double error_estimate = 0.;  ///< relative, of the peak contact pressure; where an edge pressure
                               ///< is not bounded, of that in the middle half of the length
  double correction = 0.;      ///< relative, of the same pressure: what its extrapolation to ever
                               ///< finer cells around the contact adds to that of the mesh
  std::optional<EdgePressure> edge;  ///< in 3-D
  bool has_free_ends = false;  ///< whether a contact ends within the surfaces: only then do figures
                               ///< depend on the cells around it
  Stop stop;                   ///< of the refinement
};

}  // namespace geneva::fem
