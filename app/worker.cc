#include "app/worker.h"

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>

#include "app/exit_code.h"
#include "app/launch.h"
#include "app/workers.h"
#include "base/output_file.h"

namespace geneva::app {

namespace {

/// [bytes]
double resident_memory() {
  double pages = 0.;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// All that is printed from now on goes into a file.
void print_into(const std::string& file) {
  constexpr mode_t readable = 0644;
  const int log = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
  if (log < 0) base::refuse_by_system("cannot write " + file);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::close(log);
  std::cout.clear();  // of a log that could not be written whole
}

}  // namespace

std::FILE* take_replies() {
  std::FILE* const replies = ::fdopen(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3), "w");
  if (replies == nullptr) base::refuse_by_system("cannot answer");
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  return replies;
}

int work(std::FILE* const replies, const std::function<int(const std::filesystem::path&)>& run) {
  constexpr double most_growth =
      1e8;  // what is left of a large case counts for the next one's limit
  const double at_start = resident_memory();
  for (std::string directory, log;
       std::getline(std::cin, directory, '\0') && std::getline(std::cin, log, '\0');) {
    const auto solve = [&] {
      print_into(log);
      return run(directory);
    };
    const int code = with_output_checked(exit_code_of(solve, "run " + directory, say_failure));
    std::cerr.flush();
    print_into("/dev/null");  // what comes between two cases belongs to neither
    ::malloc_trim(0);
    const bool is_used_up = resident_memory() > at_start + most_growth;
    std::fprintf(replies, "%d %s\n", code, is_used_up ? worker_is_used_up : worker_goes_on);
    std::fflush(replies);
  }
  std::fclose(replies);
  return 0;
}

}  // namespace geneva::app
