#pragma once

#include <mpi.h>

#include <filesystem>

#include "mesh/mesher.h"

namespace geneva::app {

/// `geneva design --crown`: searches for the most even pin, solves it by finite elements, prints it
/// before and after, and writes the results.
/// @param output where they go; empty: results in the case's directory
/// @param mesher on rank 0
/// @return the exit code: 0, or 2 if the accuracy was not reached
int confirmed_crown_of_case(MPI_Comm communicator, const std::filesystem::path& case_directory,
                            const std::filesystem::path& output, mesh::Mesher* mesher);

}  // namespace geneva::app
