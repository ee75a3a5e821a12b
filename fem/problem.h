#pragma once

#include <array>
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

/// Linear elastic isotropic material.
struct Material {
  double youngs_modulus;  ///< E [Pa], > 0
  double poissons_ratio;  ///< nu, -1 < nu < 0.5
};

/// Rotation of a body about the origin, whose inertia loads it: rho (omega^2 r - alpha x r).
///
/// The density is not given: on every mesh it is set so that the body's moment of inertia is the
/// given one.
struct Rotation {
  double inertia = 0.;       ///< J about the origin [kg m^2], >= 0; 0: no inertia load
  double speed = 0.;         ///< omega [rad/s], counter-clockwise
  double acceleration = 0.;  ///< alpha [rad/s^2], counter-clockwise
};

struct BodyForce {
  std::array<double, 2> uniform{0., 0.};  ///< force per volume [N/m^3]
  Rotation rotation;
};

struct Body {
  std::string name;
  Material material;
  BodyForce force;
};

/// Prescribed displacement [m] of a surface, by component; a component without a value is free.
struct Support {
  std::string surface;
  std::array<std::optional<double>, 2> displacement;
};

/// Force per area on a surface: traction - pressure * outward normal [Pa].
struct SurfaceLoad {
  std::string surface;
  double pressure = 0.;
  std::array<double, 2> traction{0., 0.};
};

/// A surface held rigidly that moves along one direction only, under a total force along it.
struct RigidTie {
  std::string surface;
  std::array<double, 2> direction;  ///< unit vector
  double force;                     ///< [N], in the direction
};

/// Frictionless contact of two surfaces; the source carries the pressure unknowns.
struct ContactPair {
  std::string source;
  std::string target;
};

/// A plane elastic contact problem, all by name, SI units.
struct Problem {
  PlaneKind plane = PlaneKind::plane_strain;
  double thickness = 1.;  ///< [m], > 0; not used in an axisymmetric model
  std::vector<Body> bodies;
  std::vector<Support> supports;
  std::vector<SurfaceLoad> loads;
  std::vector<RigidTie> ties;
  std::vector<ContactPair> pairs;
};

/// When to stop refining, and what limits the effort.
struct Settings {
  double accuracy = 0.005;          ///< wanted relative error of the peak contact pressure, > 0
  unsigned int max_levels = 20;     ///< refinements of the coarse mesh
  unsigned int max_dofs = 2000000;  ///< displacement unknowns
  double max_memory = 16e9;         ///< peak resident memory of all ranks together [bytes]
  unsigned int max_active_set_steps = 50;
  double linear_tolerance = 1e-10;  ///< of the conjugate gradients, relative to the load
};

}  // namespace geneva::fem
