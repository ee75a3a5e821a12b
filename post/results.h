#pragma once

#include <optional>
#include <vector>

#include "fem/solution.h"
#include "post/closed_form.h"
#include "post/stress.h"

namespace geneva::post {

/// How well the forces balance; relative to the contact force (moments: times the extent of the
/// model).
struct Equilibrium {
  double force_defect;
  double moment_defect;  ///< 0 in an axisymmetric model
};

/// Root-mean-square difference from McEwen's stress over |x| < 2 b, z < 3 b, relative to p0
/// (Frobenius norm of the in-plane tensor).
struct FieldDifference {
  double source_body;
  double target_body;
};

/// One contact pair beside its closed form.
struct ContactAnalysis {
  PressureCentre centre;
  std::optional<ClosedForm> hertz;
  StressPeak max_shear;    ///< greatest in-plane shear [Pa] below the contact
  double max_shear_depth;  ///< [m]
  std::optional<FieldDifference> difference;
};

/// What the program reports of a solution.
struct Results {
  NodalStress nodal;
  std::vector<ContactAnalysis> contacts;  ///< by contact pair
  std::vector<StressPeak> max_von_mises;  ///< by body
  Equilibrium equilibrium;
};

Results analyse(const fem::Solution<2>& solution);

/// The contact pair with the greatest pressure.
std::size_t leading_contact(const fem::Solution<2>& solution);

}  // namespace geneva::post
