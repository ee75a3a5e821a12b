#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cad/file_unit.h"
#include "loads/wheel/outline.h"

namespace geneva::cad {

/// Writes a drawing of lines, true arcs and circles (DXF of AutoCAD 2000) with a layer for each
/// outline, which has its name.
/// @throws base::InputError if the file cannot be written
void write_dxf(const std::filesystem::path& file, const std::vector<loads::Outline>& outlines,
               FileUnit unit);

/// Of each layer the area within its largest closed chain of lines, arcs and circles less those
/// within the others, its holes [m^2].
/// @throws base::InputError if the file cannot be read, or a chain is not closed
std::map<std::string, double> areas_of_dxf(const std::filesystem::path& file, FileUnit unit);

}  // namespace geneva::cad
