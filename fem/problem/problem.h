#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace geneva::fem {

/// What the two coordinates of a plane model stand for.
enum class PlaneKind {
  plane_strain,  ///< no strain along the thickness
  plane_stress,  ///< no stress along the thickness
  axisymmetric   ///< x is the radius, y the axis of revolution
};

/// Components of a vector.
template <int dim>
using Components = std::array<double, static_cast<std::size_t>(dim)>;

/// Euclidean length, in the unit of the components.
template <std::size_t dim>
double magnitude(const std::array<double, dim>& components) {
  return std::sqrt(
      std::inner_product(components.begin(), components.end(), components.begin(), 0.));
}

/// Linear elastic isotropic material.
struct Material {
  double youngs_modulus;  ///< E [Pa], > 0
  double poissons_ratio;  ///< nu, -1 < nu < 0.5
};

/// Rotation of a body about the origin, in 3-D about the z axis, whose inertia loads it:
/// rho (omega^2 r - alpha x r).
///
/// rho is not the body's density: on every mesh it is set so that the moment of inertia is the
/// given one, which may be that of all that turns with the body.
struct Rotation {
  double inertia = 0.;       ///< J about the origin [kg m^2], >= 0; 0: no inertia load
  double speed = 0.;         ///< omega [rad/s], counter-clockwise
  double acceleration = 0.;  ///< alpha [rad/s^2], counter-clockwise
};

template <int dim>
struct BodyForce {
  Components<dim> uniform{};       ///< force per volume [N/m^3]
  Components<dim> acceleration{};  ///< force per mass, such as gravity [m/s^2]
  Rotation rotation;
  /// Angular speed about the origin, in 3-D about the z axis, in an axisymmetric model about the
  /// axis of revolution [rad/s]: density times its square times the radius is added.
  double spin = 0.;
};

template <int dim>
struct Body {
  std::string name;
  Material material;
  BodyForce<dim> force;
  double density = 0.;      ///< [kg/m^3], >= 0
  bool is_cut_out = false;  ///< of a larger body, whose stresses away from the contacts it has not
};

/// Prescribed displacement [m] of a surface, by component; a component without a value is free.
template <int dim>
struct Support {
  std::string surface;
  std::array<std::optional<double>, static_cast<std::size_t>(dim)> displacement;
};

/// Force per area on a surface: traction - pressure * outward normal [Pa].
template <int dim>
struct SurfaceLoad {
  std::string surface;
  double pressure = 0.;
  Components<dim> traction{};
};

/// A surface held rigidly that moves along one direction only, under a total force along it.
template <int dim>
struct RigidTie {
  std::string surface;
  Components<dim> direction;  ///< unit vector
  double force;               ///< [N], in the direction
};

/// Coulomb's friction: along the surfaces the source is held back by mu times the pressure at most.
struct Friction {
  double coefficient = 0.;  ///< mu, >= 0
  /// Velocity of the source against the target where all of it slides, of any length; in the plane
  /// the third is 0. Zeros: it sticks and slides as the loads have it.
  std::array<double, 3> sliding{};

  [[nodiscard]] bool slides() const { return sliding != std::array<double, 3>{}; }
};

/// Contact of two surfaces; the source carries the pressure unknowns.
struct ContactPair {
  std::string source;
  std::string target;
  /// In 3-D: what crowning, tilt and edge breaks, which the mesh does not show, add to the gap
  /// [m] at a place z [m]; may be empty.
  std::function<double(double)> clearance = {};
  Friction friction = {};
};

/// "'source -> target'".
inline std::string quoted(const ContactPair& pair) {
  return "'" + pair.source + " -> " + pair.target + "'";
}

/// Shares of a problem's loads that act at one instant, in the order of the problem; where a list
/// is empty, all of them act in full.
struct Load {
  std::vector<double> body_forces;    ///< by body
  std::vector<double> surface_loads;  ///< by surface load
  std::vector<double> ties;           ///< by tie, of its force
  std::vector<double> supports;       ///< by support, of its prescribed displacements
  double time = 0.;                   ///< of the instant [s]; for the reader alone
};

/// An elastic problem with contact or without, in the plane or in 3-D, all by name, SI units.
template <int dim>
struct Problem {
  PlaneKind plane = PlaneKind::plane_strain;  ///< not used in 3-D
  double thickness = 1.;  ///< [m], > 0; not used in an axisymmetric model and in 3-D
  std::vector<Body<dim>> bodies;
  std::vector<Support<dim>> supports;
  std::vector<SurfaceLoad<dim>> loads;
  std::vector<RigidTie<dim>> ties;
  std::vector<ContactPair> pairs;
  /// What acts at one instant after the other, which friction remembers; the last one is analysed.
  /// Empty: all loads at once.
  std::vector<Load> steps = {};
};

template <int dim>
bool has_contact(const Problem<dim>& problem) {
  return !problem.pairs.empty();
}

template <int dim>
bool has_friction(const Problem<dim>& problem) {
  return std::any_of(problem.pairs.begin(), problem.pairs.end(),
                     [](const ContactPair& pair) { return pair.friction.coefficient > 0.; });
}

/// Whether a support moves, so that not loads alone decide the forces.
template <int dim>
bool has_prescribed_displacement(const Problem<dim>& problem) {
  return std::any_of(problem.supports.begin(), problem.supports.end(), [](const auto& support) {
    return std::any_of(support.displacement.begin(), support.displacement.end(),
                       [](const auto& component) { return component.value_or(0.) != 0.; });
  });
}

/// Whether supports that move press the bodies and no load does.
template <int dim>
bool is_pressed_by_supports(const Problem<dim>& problem) {
  const auto is_loaded = [](const Body<dim>& body) {
    const BodyForce<dim>& force = body.force;
    return force.uniform != Components<dim>{} || force.acceleration != Components<dim>{} ||
           force.rotation.inertia != 0. || force.spin != 0.;
  };
  return has_prescribed_displacement(problem) && problem.loads.empty() && problem.ties.empty() &&
         std::none_of(problem.bodies.begin(), problem.bodies.end(), is_loaded);
}

/// Ratio of the stiffnesses of two bodies from which on point smoothers fail. Up to it the
/// multigrid takes 38 iterations at most, with a ratio of 1000 it takes 116; in 3-D that holds
/// for a stiff source.
constexpr double very_stiff = 100.;

}  // namespace geneva::fem
