#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <optional>

#include "loads/hertz.h"
#include "post/analysis/contact_frame.h"

namespace geneva::post {

/// Hertz's solution of a contact in 3-D for the force that it carries.
struct ClosedFormInSpace {
  std::optional<loads::HertzLine> line;        ///< evenly loaded over the loaded length
  std::optional<loads::HertzEllipse> ellipse;  ///< where the contact ends before the surfaces do
  loads::HertzLine
      even;       ///< as if loaded evenly where the surfaces face each other (Johnson 1956, Eq. 2)
  double force;   ///< of the whole contact [N]
  double length;  ///< along the contact that carries load [m]
  double middle;  ///< of that length, along the contact from the centre of pressure [m]
  double poissons_ratio;   ///< of the body with the greater shear
  double radius_across;    ///< relative radii [m]
  double radius_along;     ///< infinite for a line
  double contact_modulus;  ///< E* [Pa]
  /// mu of a contact that slides everywhere, > 0 where the target's traction points along
  /// ContactFrame::across; only sliding across a line is known
  double friction;

  [[nodiscard]] double peak_pressure() const;
  /// Half of the contact's extent across.
  [[nodiscard]] double half_width() const;
  /// Half of its extent along.
  [[nodiscard]] double half_length() const;
  /// Maximum shear stress below the contact [Pa], and its depth [m]; unknown for an ellipse that
  /// is no circle, and where the contact slides.
  [[nodiscard]] std::optional<double> max_shear() const;
  [[nodiscard]] std::optional<double> max_shear_depth() const;
  /// Pressure at distances from the centre across and along [Pa].
  [[nodiscard]] double pressure(double across, double along) const;
  /// Whether a distance from the centre along the contact is within the loaded length.
  [[nodiscard]] bool is_on_line(double along) const;

  [[nodiscard]] bool is_circle() const;

 private:
  [[nodiscard]] loads::HertzPoint as_point() const;
};

/// McEwen's stress [Pa] below an evenly loaded line in plane strain, with that of the friction
/// where it slides, at a place within a body with the given Poisson's ratio.
/// @return nothing outside |x| < 4 b, 0 <= z < 6 b and the loaded length, and for an ellipse
std::optional<dealii::SymmetricTensor<2, 3>> mcewen_stress(const ClosedFormInSpace& form,
                                                           const ContactFrame& frame,
                                                           double poissons_ratio,
                                                           const dealii::Point<3>& place);

/// From cylinders and spheres, the clearance along z and the materials of the two surfaces; nothing
/// where Hertz does not apply.
std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame);

}  // namespace geneva::post
