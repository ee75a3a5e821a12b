#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/case.h"
#include "loads/wheel/solid_part.h"

namespace geneva {

/// The drawn parts of a mechanism, SI units.
struct CadExport {
  Case given;
  double driver_angle;                  ///< of the assembly, from the first pin's middle [rad]
  std::vector<loads::SolidPart> parts;  ///< wheel, driver, pins, where they stand
  std::vector<std::string> notices;     ///< what is drawn otherwise than the case says, or not
};

/// A file as it was read back after it was written.
struct CadFile {
  std::string name;
  std::vector<std::string> bodies;  ///< of a drawing its layers
  double size;                      ///< volume [m^3], of a drawing area [m^2], of all bodies
  double deviation;                 ///< greatest of a body from its closed form, relative
};

/// Wheel, driver with locking disc, and pins of a mechanism as solids.
/// @param driver_angle of the assembly [rad]; none: where the case wants to be analysed
/// @throws InputError if the case has no mechanism whose wheel is drawn
CadExport cad_export(const Case& given, std::optional<double> driver_angle);

/// Writes each part and the assembly as STEP and DXF, in millimetres, with 'Output units = in-lbf'
/// in inches, and reads them back. Other files of the directory stay.
/// @throws InputError if the directory cannot be written; it is then as it was
/// @throws std::logic_error if a file read back differs from its closed form by more than 1e-9
std::vector<CadFile> write(const CadExport& drawing, const std::filesystem::path& directory);

}  // namespace geneva
