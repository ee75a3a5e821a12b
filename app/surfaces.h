#pragma once

#include <filesystem>

namespace geneva::mesh {
class Mesher;
}

namespace geneva::app {

/// `geneva surfaces`: prints the bodies and surfaces that a case may name of its geometry file, and
/// draws them.
/// @param output the page with the pictures; empty: surfaces.html in the case's directory
/// @param mesher on rank 0; the other ranks do nothing
/// @return exit code 0
int surfaces_of_case(const std::filesystem::path& case_directory,
                     const std::filesystem::path& output, mesh::Mesher* mesher);

}  // namespace geneva::app
