#include "model/model.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "fem/problem/problem_check.h"
#include "fem/problem/source_sides.h"
#include "loads/pi.h"
#include "mesh/compact_cells.h"
#include "mesh/extrusion.h"
#include "mesh/filled_hole.h"
#include "mesh/kinks.h"
#include "mesh/outline_mesh.h"
#include "mesh/triangulation.h"
#include "mesh/user_geometry.h"
#include "model/contact_geometry.h"
#include "model/pin_extrusion.h"
#include "model/pin_in_space.h"
#include "model/together.h"

namespace geneva::model {

namespace {

/// Whether the wheel is so soft that in 3-D, where systems are not factorised, its wall has to be
/// the contact's source: with a stiff one the conjugate gradients take hundreds of iterations.
bool is_on_soft_wheel(const MechanismCase& mechanism) {
  return mechanism.pin.youngs_modulus > fem::very_stiff * mechanism.wheel.youngs_modulus;
}

/// Between the wall and a pin that is fixed to its carrier, which slides along x all over; none
/// where it only rolls. A roller's friction acts in its bore.
fem::Friction wall_friction(const MechanismCase& mechanism, const MechanismState& state,
                            const std::string& source) {
  const double of_source = source == "pin" ? 1. : -1.;
  if (mechanism.roller || state.load.slip_speed == 0.) return {};
  return {mechanism.slot_friction, {std::copysign(1., of_source * state.load.slip_speed), 0., 0.}};
}

/// The wheel is held where it drives its load, and its inertia is spread over it; a block has none.
template <int dim>
fem::Problem<dim> mechanism_problem(const MechanismCase& mechanism, const MechanismState& state,
                                    const mesh::MeshData<dim>& mesh,
                                    const std::string& held_surface) {
  fem::Problem<dim> problem;
  problem.plane = fem::PlaneKind::plane_strain;
  problem.thickness = state.sizes.thickness;
  const bool is_half = is_half_model(mechanism);
  const double share = is_half ? 0.5 : 1.;
  const fem::Rotation rotation{share * state.train.wheel_inertia, state.load.wheel_speed,
                               state.load.wheel_acceleration};
  for (const std::string& body : mesh.bodies) {
    const bool is_wheel = body == "wheel";
    const CaseMaterial& material = is_wheel         ? mechanism.wheel
                                   : body == "stud" ? mechanism.stud
                                                    : mechanism.pin;
    problem.bodies.push_back(
        {body, {material.youngs_modulus, material.poissons_ratio}, {}, material.density});
    if (is_wheel && !mechanism.is_local) problem.bodies.back().force.rotation = rotation;
    problem.bodies.back().is_cut_out = is_wheel && mechanism.is_local;
  }
  fem::Support<dim> support{held_surface, {}};
  support.displacement.fill(0.);
  problem.supports.push_back(support);
  if constexpr (dim == 3)
    for (const char* const surface : {"wheel middle", "pin middle"})
      if (is_half) problem.supports.push_back({surface, {std::nullopt, std::nullopt, 0.}});
  fem::RigidTie<dim> tie{
      mechanism.space ? pin_holder(mechanism) : "pin core", {}, share * state.load.force};
  tie.direction[1] = 1.;
  problem.ties.push_back(tie);
  problem.pairs.push_back(dim == 3 && is_on_soft_wheel(mechanism)
                              ? fem::ContactPair{"driving wall", "pin"}
                              : fem::ContactPair{"pin", "driving wall"});
  problem.pairs.back().friction = wall_friction(mechanism, state, problem.pairs.back().source);
  if constexpr (dim == 2)
    if (mechanism.bore_clearance) {
      problem.supports.push_back({"roller guide", {0., std::nullopt}});
      problem.pairs.push_back({"stud", "roller bore"});
    }
  if (mechanism.space)
    problem.pairs.back().clearance = [clearance = pin_clearance(mechanism, state)](const double z) {
      return clearance.at(z);
    };
  return problem;
}

/// Pin and wheel in the plane, or extruded.
template <int dim>
mesh::MeshData<dim> mechanism_mesh(const MechanismCase& mechanism, const MechanismState& state,
                                   const ContactGeometry& geometry, mesh::Mesher& mesher,
                                   const mesh::MesherLimits& limits) {
  mesh::MeshData<2> plane = mesh::mesh_outlines(geometry.outlines, geometry.sizing, mesher, limits);
  if constexpr (dim == 2) {
    return plane;
  } else {
    if (mechanism.pin_holding.hold != PinHolding::Hold::core &&
        !mechanism.pin_holding.bore_diameter)
      plane = mesh::with_filled_hole(plane, "pin core");
    return mesh::extruded(plane,
                          extrusions(plane.bodies, mechanism, state, geometry.sizing.at_contact),
                          grading(mechanism, state));
  }
}

/// Runs a task on rank 0 that may refuse its input, and makes all ranks refuse together.
template <int dim>
mesh::MeshData<dim> meshed_on_rank_zero(const MPI_Comm communicator,
                                        const std::function<mesh::MeshData<dim>()>& task) {
  mesh::MeshData<dim> mesh;
  together(communicator, [&] {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0) mesh = task();
  });
  return mesh::broadcast(communicator, mesh);
}

/// The user's mesh, in the plane with cells that suit the contact.
template <int dim>
mesh::MeshData<dim> geometry_mesh(const GeometryCase& geometry, const fem::Problem<dim>& problem,
                                  mesh::Mesher& mesher, const mesh::MesherLimits& limits) {
  std::vector<std::string> bodies;
  for (const fem::Body<dim>& body : problem.bodies) bodies.push_back(body.name);
  mesh::MeshData<dim> mesh =
      mesh::read_geometry<dim>({geometry.file, geometry.length_unit, geometry.circle_tolerance,
                                bodies, geometry.picks, geometry.cell_size},
                               mesher, limits);
  if constexpr (dim == 2) {
    std::vector<std::string> surfaces;
    for (const fem::ContactPair& pair : problem.pairs)
      surfaces.insert(surfaces.end(), {pair.source, pair.target});
    mesh = mesh::with_compact_cells(mesh, surfaces);
  }
  return mesh;
}

/// Which contact surfaces are polygons.
template <int dim>
std::vector<std::string> polygon_notices(const mesh::MeshData<dim>& mesh,
                                         const fem::Problem<dim>& problem) {
  std::vector<std::string> notices;
  std::set<std::string> surfaces;
  for (const fem::ContactPair& pair : problem.pairs) surfaces.insert({pair.source, pair.target});
  for (const std::string& surface : surfaces) {
    const double kink = mesh::maximum_kink(mesh, surface);
    if (kink == 0.) continue;
    notices.push_back(fmt::format(
        "contact surface '{}' is a polygon: its flat faces meet at up to {:.3g} deg, and the peak "
        "pressure is that of its {}; if it should be round, let Gmsh know its circles or give "
        "'Circle tolerance'",
        surface, kink / loads::degree, dim == 2 ? "corners" : "edges"));
  }
  return notices;
}

/// Where the pin force is greater than at the analysed angle, if it is by a tenth of a per cent.
std::string greater_force(const MechanismState& state) {
  constexpr double worth_saying = 1e-3;
  const double angle = loads::peak_force_angle(state.driven, state.train);
  const double force = loads::pin_load(state.driven.at_engaged_angle(angle), state.train).force;
  const double excess = force / state.load.force - 1.;
  if (excess < worth_saying) return "";
  return fmt::format(
      "the pin force is greatest at {:.6g} deg, {:.{}f} % above that here ('Driver angle = at "
      "maximum pin force')",
      angle / loads::degree, 100. * excess, excess < 0.1 ? 1 : 0);
}

/// That a roller in 3-D is a solid pin, which bends less than a roller's stud, if it is one.
std::string solid_roller(const MechanismCase& mechanism) {
  if (!mechanism.roller || !mechanism.space || mechanism.pin_holding.hold == PinHolding::Hold::core)
    return "";
  return "in 3-D the roller is one solid pin of its diameter, which bends less than the stud "
         "it turns on: the pressure at the wall's edges is the lesser for it; the stress at the "
         "stud's root is by beam theory";
}

/// That the analysed angle is one at which slot friction turns round, if it is.
std::string friction_reversal(const MechanismCase& mechanism, const MechanismState& state) {
  constexpr double at_rest = 1e-6;
  const loads::PinLoad& load = state.load;
  const double speed = 0.5 * state.sizes.pin_diameter * std::abs(load.pin_turn_speed);
  if (mechanism.slot_friction == 0. || mechanism.roller) return "";
  if (std::abs(load.slip_speed) > at_rest * speed) return "";
  return fmt::format(
      "at {:.6g} deg the pin's sliding on the wall turns round, and the pin force jumps with its "
      "friction: what is analysed is one side of the jump ('geneva kinematics' shows both)",
      load.driver_angle / loads::degree);
}

}  // namespace

template <int dim>
Model<dim> make_model(const MPI_Comm communicator, const Case& given, mesh::Mesher* const mesher) {
  if (given.synthesis)
    refuse_model(given, "there is no contact to solve", "geneva run", "mechanism or geometry");
  Model<dim> model;
  const mesh::MesherLimits limits{given.settings.max_memory,
                                  std::min(given.settings.max_seconds, mesh::longest_meshing)};
  const auto on_rank_zero = [&](const auto& task) {
    model.mesh = meshed_on_rank_zero<dim>(communicator, task);
    if (mesher) model.gmsh_version = mesher->gmsh_version();
  };
  if (given.mechanism) {
    model.mechanism = mechanism_state(*given.mechanism);
    model.notices = notices_of(*given.mechanism, given.units);
    for (const std::string& notice :
         {greater_force(*model.mechanism), friction_reversal(*given.mechanism, *model.mechanism),
          solid_roller(*given.mechanism)})
      if (!notice.empty()) model.notices.push_back(notice);
    const MechanismState& state = *model.mechanism;
    const ContactGeometry geometry = contact_geometry(*given.mechanism, state);
    on_rank_zero(
        [&] { return mechanism_mesh<dim>(*given.mechanism, state, geometry, *mesher, limits); });
    model.held_surface = geometry.held_surface;
    model.problem = mechanism_problem(*given.mechanism, state, model.mesh, geometry.held_surface);
    return model;
  }
  model.problem = std::get<fem::Problem<dim>>(given.geometry->problem);
  on_rank_zero([&] { return geometry_mesh(*given.geometry, model.problem, *mesher, limits); });
  model.notices = polygon_notices(model.mesh, model.problem);
  if (mesher && !mesher->was_enclosed())
    model.notices.push_back(
        "this system cannot shut Gmsh in (Landlock and seccomp of Linux 5.13): only its time and "
        "memory were limited; run no geometry of people whom you do not trust");
  fem::order_bodies(model.problem, model.mesh);
  fem::take_softer_sources(model.problem, model.mesh);
  return model;
}

template Model<2> make_model(MPI_Comm, const Case&, mesh::Mesher*);
template Model<3> make_model(MPI_Comm, const Case&, mesh::Mesher*);

}  // namespace geneva::model
