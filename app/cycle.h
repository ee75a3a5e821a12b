#pragma once

#include <mpi.h>

#include <filesystem>

namespace geneva::mesh {
class Mesher;
}

namespace geneva::app {

/// `geneva cycle`: solves the contact over the engagements, prints the instants and writes the
/// results.
/// @param output where they go; empty: results in the case's directory
/// @return exit code
int cycle_of_case(MPI_Comm communicator, const std::filesystem::path& case_directory,
                  const std::filesystem::path& output, mesh::Mesher* mesher);

}  // namespace geneva::app
