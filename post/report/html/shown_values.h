#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/units.h"

namespace geneva::post {

/// A quantity of a document, for a row of a table.
struct NamedQuantity {
  const char* key;
  const char* name;
  base::Dimension dimension;
};

/// Multiples of a round step (1, 2 or 5 times a power of ten) from one number to another.
/// @param count about so many of them, 1 or more
std::vector<double> round_numbers(double from, double to, int count);

/// A number with so many significant digits, thousands apart from five digits on; without a power
/// of ten between 1e-4 and 1e9, and without the roundings and the sign of what is 0.
std::string significant(double value, int digits);

/// Fewer round numbers, so that they stand apart, written with so many significant digits.
/// @param letters that fit beside each other
std::vector<double> numbers_that_fit(double from, double to, int count, int digits,
                                     std::size_t letters);

/// Letters of a text in UTF-8, of which some take several bytes.
std::size_t n_letters(const std::string& text);

/// The digits before the point in groups of three from five of them on: "41 140".
std::string grouped(const std::string& number);

/// The number of a quantity {"value", "unit"} [SI], or the plain number; not a number for null.
double number_of(const nlohmann::json& quantity);

/// The same in output units.
double in_units(const nlohmann::json& quantity, base::Dimension dimension, base::UnitSystem units);

/// The same as text with five digits, a dash for null.
std::string shown(const nlohmann::json& quantity, base::Dimension dimension,
                  base::UnitSystem units);

/// "± 0.17 %" of an estimated relative error; "not known" from 100 % on, nothing for null.
std::string shown_error(const nlohmann::json& error);

/// A unit as print has it: "rad/s²", "lbf·in", "MPa·mm/s".
std::string shown_unit(const std::string& unit);

/// A value of a case as print has it: numbers with at most six digits, thousands apart, and units:
/// "10 472 rad/s²" of "10471.9755 rad/s^2".
std::string shown_input(const std::string& value);

/// "contact force [lbf]"; the name alone if the dimension has no unit.
std::string labelled(const std::string& name, base::Dimension dimension, base::UnitSystem units);

}  // namespace geneva::post
