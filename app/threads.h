#pragma once

namespace geneva::app {

/// Keeps the linear algebra libraries of this process to one thread, whichever are installed:
/// threads that OpenBLAS or OpenMP start beside the MPI ranks wait by spinning on the ranks' cores.
void use_one_thread();

}  // namespace geneva::app
