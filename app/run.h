#pragma once

#include <mpi.h>

#include <filesystem>

#include "mesh/mesher.h"

namespace geneva::app {

/// How a run is wanted.
struct RunRequest {
  std::filesystem::path output;  ///< where the results go; empty: CASE_DIR/results
  bool is_continued = false;     ///< from the checkpoint of an earlier run
};

/// Solves a case and writes its results.
/// @param mesher on rank 0
/// @return exit code: 0, or 2 if the accuracy was not reached (the last good results are written
/// all the same)
/// @throws base::InputError if the case is wrong or there is no checkpoint of it to go on from
/// @throws base::LimitReached if there is nothing to write
int run_case(MPI_Comm communicator, const std::filesystem::path& case_directory,
             const RunRequest& request, mesh::Mesher* mesher);

}  // namespace geneva::app
