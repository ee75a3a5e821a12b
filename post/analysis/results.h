#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/solution.h"
#include "post/analysis/closed_form.h"
#include "post/analysis/closed_form_in_space.h"
#include "post/analysis/contact_sections.h"
#include "post/analysis/depth_line.h"
#include "post/analysis/field_difference.h"
#include "post/analysis/sliding_surface.h"
#include "post/analysis/stress.h"

namespace geneva::post {

/// How well the forces balance; relative to the contact force, without contact to the maximum
/// stress on the square of the model's extent, in the plane on extent times thickness (moments:
/// times the extent).
struct Equilibrium {
  double force_residual;
  double moment_residual;  ///< 0 in an axisymmetric model
};

/// One contact pair beside its closed form.
template <int dim>
struct ContactAnalysis;

template <>
struct ContactAnalysis<2> {
  PressureCentre centre;
  std::optional<ClosedForm> hertz;
  std::string hertz_objection;                ///< why it is left out
  StressPeak<2> max_shear;                    ///< maximum in-plane shear [Pa] below the contact
  double max_shear_depth;                     ///< [m]
  std::optional<SurfaceExtremes> surface;     ///< with friction
  std::optional<FieldDifference> difference;  ///< of analyse() only
  std::vector<DepthSample> depth_line;        ///< the same
};

template <>
struct ContactAnalysis<3> {
  ContactFrame frame;
  std::optional<ClosedFormInSpace> hertz;
  std::string hertz_objection;           ///< why it is left out
  std::vector<ContactSection> sections;  ///< by ascending z
  fem::Components<3> peak_place;         ///< of the contact pressure [m]
  double half_width;                     ///< across z: of the middle section; of an ellipse [m]
  double half_length;                    ///< along z [m]
  double max_shear;                      ///< maximum shear [Pa] below the contact
  double max_shear_depth;                ///< [m]
};

/// What the program reports of a solution.
template <int dim>
struct Results {
  std::vector<CellStress<dim>> cells;  ///< of this rank
  NodalStress<dim> nodal;
  std::vector<ContactAnalysis<dim>> contacts;  ///< by contact pair
  std::vector<StressPeak<dim>> max_von_mises;  ///< by body
  Equilibrium equilibrium;
};

template <int dim>
Results<dim> analyse(const fem::Solution<dim>& solution);

/// The figures of one contact and their closed forms, without what takes the stress at the nodes.
ContactAnalysis<2> contact_analysis(const fem::Solution<2>& solution,
                                    const fem::ContactResult<2>& contact,
                                    const std::vector<CellStress<2>>& cells);
ContactAnalysis<3> contact_analysis(const fem::Solution<3>& solution,
                                    const fem::ContactResult<3>& contact,
                                    const std::vector<CellStress<3>>& cells);

/// Whether linear elasticity knows a finite pressure for every contact: false where one reaches a
/// sharp edge.
template <int dim>
bool is_bounded(const fem::Solution<dim>& solution);

/// Half-width of a contact [m]; in 3-D of its middle section, or the semi-axis across z.
double half_width(const fem::ContactResult<2>& contact, const ContactAnalysis<2>& analysis);
double half_width(const fem::ContactResult<3>& contact, const ContactAnalysis<3>& analysis);

/// Hertz's pressure at a node of the contact [Pa]; not a number without a closed form.
double hertz_pressure(const ContactAnalysis<2>& analysis, const fem::ContactNode<2>& node);
double hertz_pressure(const ContactAnalysis<3>& analysis, const fem::ContactNode<3>& node);

/// The contact pair with the maximum pressure, of a problem that has some.
template <int dim>
std::size_t leading_contact(const fem::Solution<dim>& solution);

}  // namespace geneva::post
