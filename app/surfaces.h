#pragma once

#include <filesystem>

namespace geneva::mesh {
class Mesher;
}

namespace geneva::app {

/// `geneva surfaces`: prints the bodies and surfaces that a case may name of its geometry file.
/// @param mesher on rank 0; the other ranks do nothing
/// @return exit code 0
int surfaces_of_case(const std::filesystem::path& case_directory, mesh::Mesher* mesher);

}  // namespace geneva::app
