#include "app/model.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <functional>
#include <stdexcept>

#include "app/contact_geometry.h"
#include "fem/problem_check.h"
#include "mesh/gmsh_mesher.h"
#include "mesh/triangulation.h"
#include "mesh/user_geometry.h"

namespace geneva::app {

namespace {

/// The wheel is held where it drives its load, and its inertia is spread over it; a block has none.
fem::Problem mechanism_problem(const MechanismCase& mechanism, const MechanismState& state,
                               const mesh::MeshData& mesh, const std::string& held_surface) {
  fem::Problem problem;
  problem.plane = fem::PlaneKind::plane_strain;
  problem.thickness = state.sizes.thickness;
  const fem::Rotation rotation{state.train.wheel_inertia, state.load.wheel_speed,
                               state.load.wheel_acceleration};
  for (unsigned int body = 0; body < mesh.bodies.size(); ++body) {
    const bool is_wheel = mesh.bodies[body] == "wheel";
    const CaseMaterial& material = is_wheel ? mechanism.wheel : mechanism.pin;
    problem.bodies.push_back(
        {mesh.bodies[body],
         {material.youngs_modulus, material.poissons_ratio},
         is_wheel && !mechanism.is_local ? fem::BodyForce{{0., 0.}, rotation} : fem::BodyForce{}});
  }
  problem.supports.push_back({held_surface, {0., 0.}});
  problem.ties.push_back({"pin core", {0., 1.}, state.load.force});
  problem.pairs.push_back({"pin", "driving wall"});
  return problem;
}

/// Runs a task on rank 0 that may refuse its input, and makes all ranks refuse together.
mesh::MeshData on_rank_zero(const MPI_Comm communicator,
                            const std::function<mesh::MeshData()>& task) {
  mesh::MeshData mesh;
  std::string refusal;
  bool is_refused = false;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0) {
    try {
      mesh = task();
    } catch (const std::exception& error) {
      is_refused = true;
      refusal = error.what();
    }
  }
  if (dealii::Utilities::MPI::broadcast(communicator, is_refused))
    throw std::invalid_argument(dealii::Utilities::MPI::broadcast(communicator, refusal));
  return mesh::broadcast(communicator, mesh);
}

std::vector<std::string> notices_of(const MechanismCase& mechanism) {
  std::vector<std::string> notices;
  const loads::GenevaDimensionsInput& given = mechanism.dimensions;
  if (!loads::johnson_row(given.stations).from_table &&
      !(given.pin_diameter && given.thickness && given.locking_radius))
    notices.push_back(
        fmt::format("Johnson's Table 1 ends at 10 stations: the proportions that the case does not "
                    "give are those of "
                    "10 stations scaled with sin(pi/n), n = {}",
                    given.stations));
  return notices;
}

}  // namespace

Model make_model(const MPI_Comm communicator, const Case& given) {
  Model model;
  if (given.mechanism) {
    model.mechanism = mechanism_state(*given.mechanism);
    model.notices = notices_of(*given.mechanism);
    const MechanismState& state = *model.mechanism;
    const ContactGeometry geometry = contact_geometry(*given.mechanism, state);
    model.mesh = on_rank_zero(
        communicator, [&] { return mesh::mesh_outlines(geometry.outlines, geometry.sizing); });
    model.held_surface = geometry.held_surface;
    model.problem = mechanism_problem(*given.mechanism, state, model.mesh, geometry.held_surface);
    return model;
  }
  model.mesh = on_rank_zero(communicator, [&] {
    return mesh::read_geometry(given.geometry->file, given.geometry->length_unit);
  });
  model.problem = given.geometry->problem;
  fem::order_bodies(model.problem, model.mesh);
  return model;
}

}  // namespace geneva::app
