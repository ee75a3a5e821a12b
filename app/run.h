#pragma once

#include <mpi.h>

#include <filesystem>
#include <optional>

#include "mesh/mesher.h"

namespace geneva::app {

/// Solves a case and writes its results.
/// @param output where the results go; empty: CASE_DIR/results
/// @param mesher on rank 0
/// @return exit code: 0, or 2 if the accuracy was not reached (the last good results are written
/// all the same)
/// @throws base::InputError if the case is wrong; fem::NotConverged if there is nothing to
/// write
int run_case(MPI_Comm communicator, const std::filesystem::path& case_directory,
             const std::filesystem::path& output, std::optional<mesh::Mesher>& mesher);

}  // namespace geneva::app
