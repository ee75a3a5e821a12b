#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include "fem/problem/problem.h"
#include "mesh/mesh_data.h"
#include "mesh/mesher.h"
#include "model/input/case_file.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// A case ready to be solved.
template <int dim>
struct Model {
  mesh::MeshData<dim> mesh;
  fem::Problem<dim> problem;
  std::optional<MechanismState> mechanism;
  std::string held_surface;          ///< of the mechanism's wheel or block
  std::vector<std::string> notices;  ///< defaults that the user should know of
  std::string gmsh_version;          ///< on rank 0
};

/// Mesh and problem of a case; rank 0 meshes, all ranks get the result.
/// @param mesher on rank 0; nothing elsewhere
/// @throws base::InputError on all ranks if the case cannot be meshed
/// @throws base::LimitReached on all ranks if meshing takes more than the case allows
template <int dim>
Model<dim> make_model(MPI_Comm communicator, const Case& given, mesh::Mesher* mesher);

}  // namespace geneva::model
