#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cad/file_unit.h"
#include "loads/wheel/solid_part.h"

namespace geneva::cad {

/// Writes parts as a STEP file (AP214): one as a product, several as an assembly of products that
/// stand where they are placed, those of one name as one product. Products and faces have names.
/// @param name of the assembly
/// @throws base::InputError if the file cannot be written
void write_step(const std::filesystem::path& file, const std::vector<loads::SolidPart>& parts,
                const std::string& name, FileUnit unit);

/// A solid of a STEP file.
struct StepSolid {
  std::string name;                ///< of its product
  double volume;                   ///< [m^3]
  std::vector<std::string> faces;  ///< names of those that have one
};

/// @throws base::InputError if the file cannot be read
std::vector<StepSolid> solids_of_step(const std::filesystem::path& file);

}  // namespace geneva::cad
