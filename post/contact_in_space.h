#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include "fem/solution.h"
#include "loads/hertz.h"
#include "post/stress.h"

namespace geneva::post {

/// One section across a contact in space that extends along z.
struct ContactSection {
  double z;                ///< [m]
  double line_load;        ///< integral of the pressure across the contact [N/m]
  double peak_pressure;    ///< [Pa]
  double half_width;       ///< 2 sqrt(mean square distance), Hertz's b for his pressure [m]
  double max_shear;        ///< greatest shear stress below the contact [Pa]
  double max_shear_depth;  ///< [m]
};

/// Where a contact in space carries its load, and how the surfaces curve there.
struct ContactFrame {
  dealii::Point<3> centre;      ///< of pressure [m]; of the whole contact where the model is a part
  dealii::Tensor<1, 3> normal;  ///< target's outward unit normal there
  dealii::Tensor<1, 3> along;   ///< unit vector along the pin (z); else of the least curvature
  dealii::Tensor<1, 3> across;  ///< unit vector normal to both
  double curvature_across;      ///< of both surfaces together: 1/R1 + 1/R2 [1/m]
  double curvature_along;       ///< [1/m]
  double mean_square_across;    ///< of the pressure's distances from the centre [m^2]
  double mean_square_along;     ///< [m^2]
  std::array<bool, 3> mirrored;  ///< by x, y, z: a plane of symmetry bounds the model there

  /// How many times the model's part makes up the whole contact: 1, 2, 4.
  [[nodiscard]] double parts() const;
  /// Whether a plane of symmetry cuts a direction of the contact.
  [[nodiscard]] bool is_mirrored(const dealii::Tensor<1, 3>& direction) const;
  [[nodiscard]] double depth(const dealii::Point<3>& place) const;
  [[nodiscard]] double distance_across(const dealii::Point<3>& place) const;
  [[nodiscard]] double distance_along(const dealii::Point<3>& place) const;
};

/// @return an empty frame if the contact carries no force
ContactFrame contact_frame(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact);

/// Hertz's solution of a contact in space for the force that it carries.
struct ClosedFormInSpace {
  std::optional<loads::HertzLine> line;        ///< evenly loaded over the loaded length
  std::optional<loads::HertzEllipse> ellipse;  ///< where the contact ends before the surfaces do
  loads::HertzLine
      even;       ///< as if loaded evenly where the surfaces face each other (Johnson 1956, Eq. 2)
  double force;   ///< of the whole contact [N]
  double length;  ///< along the contact that carries load [m]
  double poissons_ratio;   ///< of the body with the greater shear
  double radius_across;    ///< relative radii [m]
  double radius_along;     ///< infinite for a line
  double contact_modulus;  ///< E* [Pa]

  [[nodiscard]] double peak_pressure() const;
  /// Half of the contact's extent across.
  [[nodiscard]] double half_width() const;
  /// Half of its extent along.
  [[nodiscard]] double half_length() const;
  /// Greatest shear stress below the contact [Pa], and its depth [m]; unknown for an ellipse that
  /// is no circle.
  [[nodiscard]] std::optional<double> max_shear() const;
  [[nodiscard]] std::optional<double> max_shear_depth() const;
  /// Pressure at distances from the centre across and along [Pa].
  [[nodiscard]] double pressure(double across, double along) const;

 private:
  [[nodiscard]] bool is_circle() const;
  [[nodiscard]] loads::HertzPoint as_point() const;
};

/// From cylinders and spheres, the clearance along z and the materials of the two surfaces; nothing
/// where Hertz does not apply.
std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame);

/// Length along z over which source and target face each other [m], that of the whole.
double common_length(const fem::ContactResult<3>& contact, const ContactFrame& frame);

/// The sections through all layers of contact nodes with one in contact, by ascending z; none if
/// the contact does not extend along z or its nodes stand in no layers. Beyond a plane of symmetry
/// z = const they are mirrored.
std::vector<ContactSection> contact_sections(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame,
                                             const std::vector<CellStress<3>>& cells);

/// Greatest shear stress of a body below the contact and its depth.
struct ShearBelow {
  double value;  ///< [Pa]
  double depth;  ///< [m]
};

/// Down to three half-widths, and twice the half-width to both sides.
ShearBelow greatest_shear(const fem::Solution<3>& solution, const ContactFrame& frame,
                          double half_width, const std::vector<CellStress<3>>& cells);

/// The section nearest to the middle of the surfaces' length.
/// @throws std::invalid_argument if there is none
const ContactSection& middle_section(const fem::ContactResult<3>& contact,
                                     const ContactFrame& frame,
                                     const std::vector<ContactSection>& sections);

/// The line load in the middle of the surfaces' length and at its more heavily loaded end [N/m].
struct LineLoad {
  double middle;
  double end;

  [[nodiscard]] double ratio() const { return middle > 0. ? end / middle : 0.; }
};
LineLoad line_load(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                   const std::vector<ContactSection>& sections);

}  // namespace geneva::post
