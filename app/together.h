#pragma once

#include <mpi.h>

#include <functional>

namespace geneva::app {

/// Runs a task on this rank and makes all ranks fail together if it fails on one.
/// @throws base::LimitReached on all ranks if the first one that failed met a limit
/// @throws std::invalid_argument on all ranks, with the message of the first one that failed
void together(MPI_Comm communicator, const std::function<void()>& task);

}  // namespace geneva::app
