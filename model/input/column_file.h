#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/units.h"

namespace geneva::model {

/// A column of a file: its name in the heading, and what it measures.
struct Column {
  std::string name;
  base::Dimension dimension;
};

/// Reads a comma-separated file: a heading "name [UNIT], name [UNIT]" and rows of two numbers;
/// empty lines and lines that start with '#' are left out.
/// @param example heading, for messages
/// @return both columns in SI units, of equal length, finite; empty if there are no rows
/// @throws base::InputError with file, line, what was found and what is wanted, if the heading
/// is another one, a unit is of another dimension or a row is not two finite numbers
std::array<std::vector<double>, 2> read_two_columns(const std::filesystem::path& file,
                                                    const std::array<Column, 2>& columns,
                                                    const std::string& example);

}  // namespace geneva::model
