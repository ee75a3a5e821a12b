#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <optional>

#include "fem/elasticity/elasticity.h"
#include "fem/solution.h"
#include "loads/hertz.h"

namespace geneva::post {

/// Hertz's solution of a computed contact between circles or a circle and a flat; SI units.
struct ClosedForm {
  std::optional<loads::HertzLine> line;    ///< plane models
  std::optional<loads::HertzPoint> point;  ///< axisymmetric models that touch on the axis
  double force;                            ///< normal force on the whole contact [N]
  double relative_radius;                  ///< [m]
  double contact_modulus;                  ///< E* [Pa]
  dealii::Point<2> centre;                 ///< centre of pressure [m]
  double centre_arc_length;                ///< the same on the source surface [m]
  dealii::Tensor<1, 2> normal;             ///< target's outward unit normal there
  /// mu of a contact that slides everywhere, > 0 where the target's traction points along the
  /// normal turned counter-clockwise
  double friction;
  loads::DeepStress sliding_shear;  ///< of lines: maximum in-plane shear with that friction

  [[nodiscard]] double peak_pressure() const {
    return line ? line->peak_pressure : point->peak_pressure;
  }
  [[nodiscard]] double half_width() const {
    return line ? line->half_width : point->contact_radius;
  }
  [[nodiscard]] double max_shear() const { return line ? sliding_shear.value : point->max_shear; }
  [[nodiscard]] double max_shear_depth() const {
    return line ? sliding_shear.depth : point->max_shear_depth;
  }
  /// Pressure at an arc length of the source surface [Pa].
  [[nodiscard]] double pressure(double arc_length) const;
  /// Distance from the contact along the common normal, positive into either body [m].
  [[nodiscard]] double depth(const dealii::Point<2>& place) const;
  /// Distance from the centre of pressure along the contact [m].
  [[nodiscard]] double along(const dealii::Point<2>& place) const;
};

/// Centre of pressure of a contact, and the target's normal there.
struct PressureCentre {
  dealii::Point<2> place;
  double arc_length;
  dealii::Tensor<1, 2> normal;
};
PressureCentre pressure_centre(const fem::Solution<2>& solution,
                               const fem::ContactResult<2>& contact);

/// Hertz's solution for the force that the contact carries, from the circles and materials of the
/// two surfaces; nothing where Hertz does not apply (both flat, conforming, no force, or off the
/// axis of an axisymmetric model).
std::optional<ClosedForm> closed_form(const fem::Solution<2>& solution,
                                      const fem::ContactResult<2>& contact);

/// McEwen's stress [Pa] at a place within a body with the given Poisson's ratio, with that of the
/// friction (Smith and Liu 1953) where the contact slides; lines in plane models only.
/// @return nothing outside |x| < 4 b, 0 <= z < 6 b
std::optional<fem::PlaneStress> mcewen_stress(const ClosedForm& form, fem::PlaneKind plane,
                                              double poissons_ratio, const dealii::Point<2>& place);

}  // namespace geneva::post
