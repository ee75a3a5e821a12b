#pragma once

#include <mpi.h>

#include <filesystem>

namespace geneva {
namespace mesh {
class Mesher;
}
namespace app {

/// `geneva design --strength`: prints the design, and the wheel's stresses away from the contact
/// against its diameter, and writes the results.
/// @param output where they go; empty: results in the case's directory
/// @return exit code 0
int design_with_strength(MPI_Comm communicator, const std::filesystem::path& case_directory,
                         const std::filesystem::path& output, mesh::Mesher* mesher);

}  // namespace app
}  // namespace geneva
