#pragma once

namespace geneva::post {

/// One section across a contact in 3-D that extends along z.
struct ContactSection {
  double z;                ///< [m]
  double line_load;        ///< integral of the pressure across the contact [N/m]
  double peak_pressure;    ///< of the parabola through the nodes' squares, see fitted_peak() [Pa]
  double half_width;       ///< 2 sqrt(mean square distance), Hertz's b for his pressure [m]
  double max_shear;        ///< maximum shear stress below the contact [Pa]
  double max_shear_depth;  ///< [m]
};

}  // namespace geneva::post
