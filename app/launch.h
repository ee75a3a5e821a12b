#pragma once

#include <string>

namespace geneva::app {

/// Whether the launcher of parallel programs, if there is one, started this process as rank 0: what
/// is known before MPI is.
bool is_launched_as_first_rank();

/// @throws base::InputError where MPI does not start: if the process may have too little memory, or
/// its current directory is no more
void check_that_mpi_can_start();

/// What is to be done, as the user wrote it.
std::string command_text(int argc, char** argv);

/// All of standard output has to arrive; that its reader may have left early is no error.
/// @return the exit code, or wrong_input in place of 0
int with_output_checked(int code);

}  // namespace geneva::app
