#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/adaptivity/level_record.h"
#include "fem/body_strength.h"
#include "fem/contact/contact_result.h"
#include "fem/discretisation/vector.h"
#include "fem/instant.h"
#include "fem/problem/moment.h"
#include "fem/problem/problem.h"
#include "fem/problem/scaling.h"
#include "fem/problem/stop.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Reaction of a support or rigid tie: force [N] and moment about the origin [N m] that it exerts
/// on its body.
template <int dim>
struct Reaction {
  std::string surface;
  Components<dim> force{};
  Moment<dim> moment{};
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
  Vector displacement;  ///< ghosted

  std::vector<ContactResult<dim>> contacts;
  std::vector<Instant<dim>> instants;    ///< by load step, of the last mesh
  std::vector<Reaction<dim>> reactions;  ///< of supports, then ties
  std::map<dealii::types::global_dof_index, double>
      held_tractions;                        ///< see tractions_of_holders() [Pa]
  Components<dim> applied_force{};           ///< of body forces and surface loads [N]
  Moment<dim> applied_moment{};              ///< about the origin [N m]
  Moment<dim> contact_couple{};              ///< see contact_couple() [N m]
  std::vector<BodyStrength<dim>> strength;   ///< by body
  std::vector<SingularPlace<dim>> singular;  ///< places left out of it
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
