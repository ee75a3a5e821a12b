#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <memory>

#include "fem/discretisation/hanging_vertices.h"
#include "fem/discretisation/mesh_fields.h"
#include "fem/discretisation/saved_field.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Cells of this level stay as they are: p4est knows one level more (P4EST_QMAXLEVEL).
template <int dim>
constexpr int deepest_level = dim == 2 ? 28 : 17;

/// A mesh that is refined in place, with its linear elements and degrees of freedom.
template <int dim>
class RefinedMesh {
 public:
  /// @param coarse SI units, the same on all ranks
  /// @param length unit of length of the triangulation [m]
  RefinedMesh(MPI_Comm communicator, const mesh::MeshData<dim>& coarse, double length);

  /// Refines the flagged cells, but for those of the deepest level.
  /// @param fields the displacement with room for ghosts, at least those of this rank's cells
  /// @return on the finer mesh, the displacement without ghosts
  MeshFields refine(MeshFields fields);

  /// Goes over to the mesh of a saved displacement. To be called on the coarse mesh.
  /// @return the displacement, without ghosts
  /// @throws base::InputError if the mesh has no such cells
  Vector refine_as(const SavedField<dim>& saved);

  /// Shared with the solution, which shows the mesh as it is when the refinement ends.
  std::shared_ptr<dealii::parallel::distributed::Triangulation<dim>> triangulation;
  std::shared_ptr<const dealii::FESystem<dim>> element;
  std::shared_ptr<dealii::DoFHandler<dim>> dof_handler;

 private:
  void number();

  VertexPlaces<dim> moved_vertices_;
};

}  // namespace geneva::fem
