#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <memory>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Sends the mesh of rank 0 to all ranks.
MeshData broadcast(MPI_Comm communicator, const MeshData& mesh);

/// Makes the distributed coarse mesh: material ids are body indices, boundary ids surface indices,
/// and every edge on a circle carries a manifold (id 1 + circle index), so that refinement follows
/// the true circle.
/// @param mesh the same on all ranks
/// @param length unit of length of the triangulation [m]: vertices are divided by it
std::unique_ptr<dealii::parallel::distributed::Triangulation<2>> make_triangulation(
    MPI_Comm communicator, const MeshData& mesh, double length);

}  // namespace geneva::mesh
