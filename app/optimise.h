#pragma once

#include <mpi.h>

#include <filesystem>

namespace geneva {
namespace mesh {
class Mesher;
}

namespace app {

/// `geneva optimise`: finds the best dimensions, solves them by finite elements, prints both and
/// writes the results. All ranks call it.
/// @param output where they go; empty: results in the case's directory
/// @return exit code
int confirmed_optimum(MPI_Comm communicator, const std::filesystem::path& case_directory,
                      const std::filesystem::path& output, mesh::Mesher* mesher);

}  // namespace app
}  // namespace geneva
