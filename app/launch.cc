#include "app/launch.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include "app/exit_code.h"
#include "base/errors.h"
#include "base/installed_program.h"

namespace geneva::app {

namespace {

/// The rank that a launcher of MPI programs gave this process; null without one.
const char* rank_of_launcher() {
  for (const char* const name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (const char* const rank = std::getenv(name)) return rank;
  return nullptr;
}

}  // namespace

bool is_launched_by_mpi() { return rank_of_launcher() != nullptr; }

bool is_launched_as_first_rank() {
  return !is_launched_by_mpi() || std::string(rank_of_launcher()) == "0";
}

bool is_launched_with_others() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* const size = std::getenv(name)) return std::string(size) != "1";
  return false;
}

void check_address_space() {
  constexpr rlim_t least = 1'000'000'000;  // with 0.6 GB the start of MPI hung
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < least)
    throw base::InputError(
        fmt::format("the address space of this process is limited to {:.3g} GB; it needs at least "
                    "{:.3g} GB: raise the limit (ulimit -v)",
                    1e-9 * static_cast<double>(limit.rlim_cur), 1e-9 * static_cast<double>(least)));
}

void check_current_directory() {
  std::error_code error;
  (void)std::filesystem::current_path(error);
  if (error)
    throw base::InputError("the current directory cannot be used (" + error.message() +
                           "): change to another one");
}

void use_one_thread() {
  for (const char* const name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) ::setenv(name, "1", 1);
}

void become(const std::string& name, char** const argv) {
  const std::string program = base::installed_program(name).string();
  use_one_thread();
  ::execv(program.c_str(), argv);
  throw base::InputError(fmt::format("{}, which belongs to geneva, cannot be started: {}", program,
                                     std::strerror(errno)));
}

std::string command_text(const int argc, char** const argv) {
  std::string text;
  for (int i = 1; i < argc; ++i) text += (i > 1 ? " " : "") + std::string(argv[i]);
  return text;
}

int with_output_checked(const int code) {
  std::cout.flush();
  const bool is_complete = std::cout.good() && std::fflush(stdout) == 0;
  if (is_complete || errno == EPIPE || code != 0) return code;
  std::cerr << "geneva: cannot write all of standard output\n";
  return wrong_input;
}

}  // namespace geneva::app
