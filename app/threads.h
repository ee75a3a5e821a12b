#pragma once

namespace geneva::app {

/// Keeps the linear algebra libraries of this process to one thread, whichever are installed:
/// threads that OpenBLAS or OpenMP start beside the MPI ranks wait by spinning on the ranks' cores.
void use_one_thread();

/// Lets the library of tasks that deal.II asks even for one thread set itself up now: where memory
/// runs out in that, it waits for ever.
void start_task_scheduler();

}  // namespace geneva::app
