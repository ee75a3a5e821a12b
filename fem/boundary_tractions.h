#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <map>
#include <vector>

#include "fem/contact/contact_result.h"
#include "fem/problem/problem.h"
#include "fem/problem/scaling.h"
#include "fem/solution.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// What is known of the traction on a boundary surface.
enum class TractionKind {
  given,     ///< by the surface's load; zero without one
  mirrored,  ///< a plane of symmetry or the axis of revolution: the field goes on as its image
  contact,   ///< of a contact pair: zero away from the nodes in contact
  held       ///< of a support or rigid tie: known at the nodes from their forces, if these are
};

template <int dim>
struct SurfaceTraction {
  TractionKind kind = TractionKind::given;
  unsigned int axis = 0;  ///< normal to the plane of symmetry
  double pressure = 0.;   ///< [Pa], see SurfaceLoad
  Components<dim> traction{};
};

/// What is known of the tractions all around the bodies.
template <int dim>
struct BoundaryTractions {
  std::vector<SurfaceTraction<dim>> surfaces;  ///< by boundary id
  std::vector<mesh::Circle> circles;           ///< in the units of the triangulation
  std::vector<dealii::Point<dim>> in_contact;  ///< source nodes that carry pressure, same units
  /// What holds a surface exerts at its nodes [Pa], beside the surface's load, by dof of the
  /// displacement.
  std::map<dealii::types::global_dof_index, double> at_held = {};
};

/// Those that are known without the forces at the nodes of held surfaces.
template <int dim>
BoundaryTractions<dim> boundary_tractions(const mesh::MeshData<dim>& mesh,
                                          const Problem<dim>& problem, const Scales& scales,
                                          const std::vector<ContactResult<dim>>& contacts);

/// Those of a solution, with what supports and ties exert at their nodes.
template <int dim>
BoundaryTractions<dim> boundary_tractions(const Solution<dim>& solution);

}  // namespace geneva::fem
