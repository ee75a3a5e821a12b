#pragma once

#include <mpi.h>

#include <functional>

namespace geneva::model {

/// Runs a task on this rank and makes all ranks fail together if it fails on one.
/// @throws base::InputError, base::LimitReached, std::bad_alloc, or std::runtime_error for all
/// else, on all ranks, with the message of the first one that failed
void together(MPI_Comm communicator, const std::function<void()>& task);

}  // namespace geneva::model
