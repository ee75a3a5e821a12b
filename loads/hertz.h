#pragma once

namespace geneva::loads {

/// Linear elastic isotropic material.
struct Elastic {
  double youngs_modulus;  ///< E [Pa], > 0
  double poissons_ratio;  ///< nu, -1 < nu < 0.5
};

/// E* with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa] (Hertz; Johnson 1956, Eq. 3): plane strain
/// and point contact.
/// @throws base::InputError if a constant is outside its range
double contact_modulus(const Elastic& first, const Elastic& second);
/// 1/E* = 1/E1 + 1/E2 [Pa]: plane stress.
/// @throws base::InputError if a constant is outside its range
double contact_modulus_plane_stress(const Elastic& first, const Elastic& second);

/// In-plane stress [Pa] of the body z >= 0, tension positive; x along the contact, z into the body.
/// The shear xz is positive if the material on the side of greater z pulls the rest towards +x:
/// equilibrium reads d xx/dx + d xz/dz = 0 and d xz/dx + d zz/dz = 0.
struct ContactStress {
  double xx;
  double zz;
  double xz;
};

/// Hertz contact of two parallel cylinders.
struct HertzLine {
  double peak_pressure;  ///< p0 [Pa]
  double half_width;     ///< b [m]
  double max_shear;  ///< maximum in-plane shear [Pa]: u^(5/2) p0 = 0.300 p0, u = (sqrt(5) - 1)/2
  double max_shear_depth;  ///< its depth [m]: u^(1/2) b = 0.786 b

  /// p(x) = p0 sqrt(1 - x^2/b^2) [Pa], 0 outside the contact.
  [[nodiscard]] double pressure(double x) const;
  /// McEwen's closed form (K. L. Johnson, Contact Mechanics, 1985, Eq. 4.49) at x [m] and depth z
  /// >= 0 [m].
  /// @throws base::InputError for a negative depth
  [[nodiscard]] ContactStress stress(double x, double z) const;
};

/// @param force_per_length F/t > 0 [N/m]
/// @param relative_radius R > 0 [m], 1/R = 1/R1 + 1/R2 (flat: 1/R2 = 0; concave: R2 < 0)
/// @param contact_modulus E* > 0 [Pa]
/// @throws base::InputError unless all are positive and finite
HertzLine hertz_line(double force_per_length, double relative_radius, double contact_modulus);

/// A maximum stress below a contact.
struct DeepStress {
  double value;  ///< [Pa]
  double depth;  ///< [m], >= 0
};

/// Maximum von Mises stress below the middle of a line contact, in plane strain: 0.557 p0 at
/// 0.704 b for nu = 0.3; (1 - 2 nu) p0 on the surface for nu below
/// 0.194.
/// @param poissons_ratio of the body, -1 < nu < 0.5
DeepStress maximum_von_mises(const HertzLine& contact, double poissons_ratio);

/// Hertz contact of two spheres (or a sphere on a flat). The maximum shear on the axis is that of
/// tau/p0 = 3/(4 (1 + zeta^2)) - (1 + nu)/2 (1 - zeta atan(1/zeta)), zeta = z/a (K. L. Johnson,
/// 1985, Eq. 3.45).
struct HertzPoint {
  double peak_pressure;    ///< p0 = (6 F E*^2/(pi^3 R^2))^(1/3) [Pa]
  double contact_radius;   ///< a = (3 F R/(4 E*))^(1/3) [m]
  double approach;         ///< a^2/R [m]
  double max_shear;        ///< maximum shear on the axis [Pa] (0.310 p0 for nu = 0.3)
  double max_shear_depth;  ///< its depth [m] (0.48 a for nu = 0.3)

  /// p(r) = p0 sqrt(1 - r^2/a^2) [Pa], 0 outside the contact.
  [[nodiscard]] double pressure(double r) const;
};

/// tau/p0 on the axis of a point contact (K. L. Johnson 1985, Eq. 3.45).
/// @param zeta depth over contact radius, >= 0
double axial_shear(double zeta, double poissons_ratio);

/// @param force F > 0 [N]
/// @param relative_radius R > 0 [m]
/// @param contact_modulus E* > 0 [Pa]
/// @param poissons_ratio of the body whose maximum shear is wanted, -1 < nu < 0.5
/// @throws base::InputError unless the first three are positive and finite and nu is in its
/// range
HertzPoint hertz_point(double force, double relative_radius, double contact_modulus,
                       double poissons_ratio);

/// Hertz contact of surfaces whose relative curvatures differ in two directions (K. L. Johnson,
/// Contact Mechanics, 1985, section 4.2c): the contact is an ellipse.
struct HertzEllipse {
  double peak_pressure;    ///< p0 = 3 F/(2 pi a b) [Pa]
  double semi_axis_long;   ///< a, along the direction of the larger relative radius [m]
  double semi_axis_short;  ///< b [m]
  double approach;         ///< [m]
};

/// a and b from the complete elliptic integrals K and E of the eccentricity (Johnson 1985, Eq.
/// 4.28).
/// @param force F > 0 [N]
/// @param larger_radius R' >= smaller_radius R'' > 0 [m], the relative radii of curvature
/// @param contact_modulus E* > 0 [Pa]
/// @throws base::InputError unless all are positive and finite and in this order
HertzEllipse hertz_ellipse(double force, double larger_radius, double smaller_radius,
                           double contact_modulus);

}  // namespace geneva::loads
