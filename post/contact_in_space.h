#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include "fem/solution.h"
#include "loads/hertz.h"
#include "post/stress.h"

namespace geneva::post {

/// One section across a contact in space, at a place along z.
struct ContactSection {
  double z;                ///< [m]
  double line_load;        ///< integral of the pressure across the contact [N/m]
  double peak_pressure;    ///< [Pa]
  double half_width;       ///< 2 sqrt(mean square distance), Hertz's b for his pressure [m]
  double max_shear;        ///< greatest shear stress below the contact [Pa]
  double max_shear_depth;  ///< [m]
};

/// Where a contact in space carries its load.
struct ContactFrame {
  dealii::Point<3> centre;      ///< of pressure [m]
  dealii::Tensor<1, 3> normal;  ///< target's outward unit normal there
  dealii::Tensor<1, 3> across;  ///< unit vector across the contact, normal to z
  double mean_square_across;    ///< of the pressure's distances from the centre [m^2]
  double mean_square_along;     ///< the same along z [m^2]

  [[nodiscard]] double depth(const dealii::Point<3>& place) const;
  [[nodiscard]] double distance_across(const dealii::Point<3>& place) const;
};

/// @return an empty frame if the contact carries no force
ContactFrame contact_frame(const fem::ContactResult<3>& contact);

/// Hertz's solution of a contact in space for the force that it carries.
struct ClosedFormInSpace {
  std::optional<loads::HertzLine> line;        ///< evenly loaded over the loaded length
  std::optional<loads::HertzEllipse> ellipse;  ///< where the contact ends before the surfaces do
  double force;                                ///< [N]
  double length;                               ///< along z that carries load [m]
  double radius_across;                        ///< relative radii [m]
  double radius_along;                         ///< infinite for a line
  double contact_modulus;                      ///< E* [Pa]

  [[nodiscard]] double peak_pressure() const;
  /// Half of the contact's extent across z.
  [[nodiscard]] double half_width() const;
  /// Half of its extent along z.
  [[nodiscard]] double half_length() const;
  /// Pressure at distances from the centre across z and along it [Pa].
  [[nodiscard]] double pressure(double across, double along) const;
};

/// From cylinders and spheres, the clearance along z and the materials of the two surfaces; nothing
/// where Hertz does not apply.
std::optional<ClosedFormInSpace> closed_form(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact);

/// Length along z over which source and target face each other [m].
double common_length(const fem::ContactResult<3>& contact);

/// The sections through all layers of contact nodes with one in contact, by ascending z.
std::vector<ContactSection> contact_sections(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const std::vector<CellStress<3>>& cells);

/// The section nearest to the middle of the surfaces' length.
/// @throws std::invalid_argument if there is none
const ContactSection& middle_section(const fem::ContactResult<3>& contact,
                                     const std::vector<ContactSection>& sections);

/// The line load in the middle of the surfaces' length and at its more heavily loaded end [N/m].
struct LineLoad {
  double middle;
  double end;

  [[nodiscard]] double ratio() const { return middle > 0. ? end / middle : 0.; }
};
LineLoad line_load(const fem::ContactResult<3>& contact,
                   const std::vector<ContactSection>& sections);

}  // namespace geneva::post
