#pragma once

#include <string>

namespace geneva::base {

/// A quantity's dimension, by the SI unit that the program computes in.
enum class Dimension {
  dimensionless,
  length,
  angle,
  slope,  ///< an angle so small that it is shown in mrad
  angular_speed,
  angular_acceleration,
  acceleration,
  stress,
  density,
  mass,
  force,
  force_per_length,
  force_per_volume,
  moment,
  inertia,
  time,
  speed,
  pressure_times_speed,
  wear_coefficient,  ///< worn volume over force and sliding distance
  memory             ///< [byte]
};

/// Name of the dimension, for messages: "length".
std::string name_of(Dimension dimension);
/// What a message asks for: "a length with its unit".
std::string wanted(Dimension dimension);
/// Examples in quotes, for messages: "'4.53 in' or '115 mm'".
std::string example_of(Dimension dimension);

/// The text in quotes, cut off where it is too long for a message.
std::string in_quotes(const std::string& text);

/// Reads "30e6 psi", "600 rpm", "2 lbf.in", "0.5 %": a number and a unit that UDUNITS-2 knows.
///
/// An angle is a dimension of its own here: 'Hz' is no angular speed and 'N.m/rad' no moment, since
/// nobody could tell turns from radians. Also known are 'deg', 'rev' and units of memory ('16 GB',
/// '16 GiB').
/// @return the value in SI units (angles in radian, dimensionless as a plain number: 0.5 % is
/// 0.005)
/// @throws InputError with the text, the dimension wanted and an example, if the number
/// or the unit is missing, the unit is unknown or of another dimension, or the value is not finite
/// @throws InputError if the unit database of UDUNITS-2 is not installed
double parse_quantity(const std::string& text, Dimension dimension);

/// Whether a text is a unit of parse_quantity(): "mm", "rpm", "%"; an empty one is none.
bool is_unit(const std::string& text);

/// The dimension of a name that name_of() gives.
/// @throws InputError if there is none
Dimension dimension_named(const std::string& name);

/// What files and tables show.
enum class UnitSystem { si, mm_newton, inch_pound };

/// As the case file names it: "SI", "mm-N", "in-lbf".
std::string name_of(UnitSystem system);

/// @throws InputError unless name_of() gives the name
UnitSystem unit_system_named(const std::string& name);

/// Name of the unit of a dimension in a unit system ("psi"; empty if dimensionless), and what to
/// multiply an SI value with to get it.
struct OutputUnit {
  std::string name;
  double factor;
};
OutputUnit output_unit(UnitSystem system, Dimension dimension);

}  // namespace geneva::base
