#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <memory>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Sends the mesh of rank 0 to all ranks.
template <int dim>
MeshData<dim> broadcast(MPI_Comm communicator, const MeshData<dim>& mesh);

/// Makes the distributed coarse mesh: material ids are body indices, boundary ids surface indices,
/// and every face on a circle or cylinder carries a manifold (id 1 + circle index), so that
/// refinement follows the true one. Where layers are graded, all else carries the manifold 0, which
/// keeps them so.
/// @param mesh the same on all ranks
/// @param length unit of length of the triangulation [m]: vertices are divided by it
template <int dim>
std::unique_ptr<dealii::parallel::distributed::Triangulation<dim>> make_triangulation(
    MPI_Comm communicator, const MeshData<dim>& mesh, double length);

}  // namespace geneva::mesh
