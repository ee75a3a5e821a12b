#pragma once

#include <string>

namespace geneva::post {

/// A quantity's dimension, by the SI unit that the program computes in.
enum class Dimension {
  dimensionless,
  length,
  angle,
  angular_speed,
  angular_acceleration,
  stress,
  density,
  force,
  moment,
  inertia,
  force_per_volume
};

/// Name of the dimension ("length") and an example of its unit ("mm"), for messages.
std::string name_of(Dimension dimension);
std::string example_of(Dimension dimension);

/// Reads "30e6 psi", "600 rpm", "2 lbf.in", "0.5 %": a number and a unit that UDUNITS-2 knows.
/// @return the value in SI units (angles in radian, dimensionless as a plain number: 0.5 % is
/// 0.005)
/// @throws std::invalid_argument with the text, the dimension wanted and an example, if the number
/// or the unit is missing, the unit is unknown or of another dimension
double parse_quantity(const std::string& text, Dimension dimension);

/// What files and tables show.
enum class UnitSystem { si, mm_newton, inch_pound };

/// Name of the unit of a dimension in a unit system ("psi"), and what to multiply an SI value with
/// to get it.
struct OutputUnit {
  std::string name;
  double factor;
};
OutputUnit output_unit(UnitSystem system, Dimension dimension);

}  // namespace geneva::post
