#pragma once

#include <string>

namespace geneva::app {

/// Whether the launcher of parallel programs, if there is one, started this process as rank 0: what
/// is known before MPI is.
bool is_launched_as_first_rank();

/// Whether a launcher of parallel programs started this process.
bool is_launched_by_mpi();

/// Whether that launcher has started other ranks as well.
bool is_launched_with_others();

/// @throws base::InputError if the process may have too little memory for MPI to start
void check_address_space();

/// @throws base::InputError if the current directory is no more
void check_current_directory();

/// Threads of the libraries for linear algebra would start with them, and take signals that others
/// wait for: programs that are started from now on have none.
void use_one_thread();

/// Replaces this process by another program of geneva, with the same command line.
/// @param name "geneva-solver"
/// @throws base::InputError if that cannot be started
[[noreturn]] void become(const std::string& name, char** argv);

/// What is to be done, as the user wrote it.
std::string command_text(int argc, char** argv);

/// All of standard output has to arrive; that its reader may have left early is no error.
/// @return the exit code, or wrong_input in place of 0
int with_output_checked(int code);

}  // namespace geneva::app
