#include "app/worker.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "app/exit_code.h"
#include "app/launch.h"
#include "base/output_file.h"

namespace geneva::app {

namespace {

/// All that is printed from now on goes into a file.
void print_into(const std::string& file) {
  constexpr mode_t readable = 0644;
  const int log = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
  if (log < 0) base::refuse_by_system("cannot write " + file);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::close(log);
}

}  // namespace

int work(const std::function<int(const std::filesystem::path&)>& run) {
  std::FILE* const replies = ::fdopen(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3), "w");
  if (replies == nullptr) base::refuse_by_system("cannot answer");
  for (std::string directory, log;
       std::getline(std::cin, directory, '\0') && std::getline(std::cin, log, '\0');) {
    const auto solve = [&] {
      print_into(log);
      return run(directory);
    };
    const int code = with_output_checked(exit_code_of(solve, "run " + directory, say_failure));
    std::cerr.flush();
    std::fprintf(replies, "%d\n", code);
    std::fflush(replies);
  }
  std::fclose(replies);
  return 0;
}

}  // namespace geneva::app
