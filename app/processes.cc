#include "app/processes.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "base/output_file.h"

namespace geneva::app {

namespace {

/// Only what a new process may do between fork and exec.
[[noreturn]] void become(char* const* const arguments, const int output, const pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(1);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

}  // namespace

Processes::~Processes() {
  for (const auto& [id, done] : running_) ::kill(id, SIGTERM);
  for (const auto& [id, done] : running_) ::waitpid(id, nullptr, 0);
}

void Processes::start(const std::vector<std::string>& command, const std::filesystem::path& output,
                      std::function<void(int)> done) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  constexpr mode_t readable = 0644;
  const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
  if (file < 0) base::refuse_by_system("cannot write " + output.string());
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(arguments.data(), file, parent);
  ::close(file);
  if (child < 0) base::refuse_by_system("cannot start " + command.front());
  running_.emplace(child, std::move(done));
}

void Processes::wait() {
  int status = 0;
  pid_t ended = -1;
  do {
    ended = ::waitpid(-1, &status, 0);
  } while (ended < 0 && errno == EINTR);
  const auto found = running_.find(ended);
  if (found == running_.end()) return;
  const std::function<void(int)> done = std::move(found->second);
  running_.erase(found);
  constexpr int signalled = 128;
  done(WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status));
}

}  // namespace geneva::app
