#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "fem/problem.h"
#include "loads/engagement.h"
#include "mesh/mesh_data.h"

namespace geneva::app {

/// What the mechanism's kinematics and torque balance say, SI units.
struct MechanismState {
  loads::GenevaDimensions dimensions;
  loads::PinLoad load;
  double inertia_from_geometry;  ///< [kg m^2]
  double inertia_used;           ///< [kg m^2]
  double expected_bore_torque;   ///< J_L a + M_f [N m]
};

/// A case ready to be solved.
struct Model {
  mesh::MeshData mesh;
  fem::Problem problem;
  std::optional<MechanismState> mechanism;
  std::vector<std::string> notices;  ///< defaults that the user should know of
};

/// Kinematics, dimensions and pin force of a mechanism case.
/// @throws std::invalid_argument where the loads room does, and if no force presses the pin on the
/// driving wall
MechanismState mechanism_state(const MechanismCase& mechanism);

/// Mesh and problem of a case; rank 0 meshes, all ranks get the result.
/// @throws std::invalid_argument on all ranks if the case cannot be meshed
Model make_model(MPI_Comm communicator, const Case& given);

}  // namespace geneva::app
