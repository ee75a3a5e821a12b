#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/units.h"

namespace geneva::model {

/// What a new case is to be.
struct Starter {
  std::string type;             ///< one of starter_types()
  std::optional<int> stations;  ///< of a mechanism; none: 6
  base::UnitSystem units;
};

/// A file of a new case.
struct StarterFile {
  std::string name;
  std::string text;
};

/// The types of mechanism, and "geometry".
std::vector<std::string> starter_types();

/// A commented case that runs as it is: case.prm, and of a geometry its file. The mechanisms are
/// some 100 mm large; numbers are in the units of the system.
/// @throws base::InputError unless the type is one of starter_types(), and for stations of a
/// geometry
std::vector<StarterFile> starter_case(const Starter& starter);

}  // namespace geneva::model
