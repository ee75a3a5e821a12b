#pragma once

#include <string>

namespace geneva::mesh::test {

/// Meshes a geometry with Gmsh itself. @return content of the file in a format of .msh
std::string saved(const std::string& geo, double version, bool binary, int dimension = 2);

}  // namespace geneva::mesh::test
