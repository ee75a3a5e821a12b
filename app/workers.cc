#include "app/workers.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <optional>
#include <utility>

#include "app/exit_code.h"
#include "app/launch.h"
#include "base/installed_program.h"
#include "base/output_file.h"

namespace geneva::app {

namespace {

constexpr int signalled = 128;

/// Variables by which a launcher of MPI programs tells a process its rank: a worker is alone.
bool is_of_launcher(const std::string& variable) {
  constexpr std::array<const char*, 3> beginnings{"OMPI_", "PMIX_", "PMI_"};
  const auto begins = [&](const char* const beginning) {
    return variable.rfind(beginning, 0) == 0;
  };
  return std::any_of(beginnings.begin(), beginnings.end(), begins) &&
         !begins("OMPI_ALLOW_RUN_AS_ROOT");
}

std::vector<char*> environment_of_worker() {
  use_one_thread();
  std::vector<char*> variables;
  const bool is_launched = is_launched_by_mpi();
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!is_launched || !is_of_launcher(*variable)) variables.push_back(*variable);
  variables.push_back(nullptr);
  return variables;
}

/// A pipe whose ends close where another program is started; none of them is a standard stream,
/// also where the user has closed those.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) base::refuse_by_system("cannot start a solver");
    constexpr int first_beyond_standard = 3;
    for (int& end : ends_) {
      if (end >= first_beyond_standard) continue;
      const int moved = ::fcntl(end, F_DUPFD_CLOEXEC, first_beyond_standard);
      ::close(end);
      end = moved;
      if (end < 0) base::refuse_by_system("cannot start a solver");
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }
  /// The caller closes it from now on.
  int take_reading() { return std::exchange(ends_[0], -1); }
  int take_writing() { return std::exchange(ends_[1], -1); }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Only what a new process may do between fork and exec.
[[noreturn]] void become(const char* const program, char* const* const arguments,
                         char* const* const variables, const Pipe& requests, const Pipe& replies,
                         const pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(1);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(requests.reading(), STDIN_FILENO);
  ::dup2(replies.writing(), STDOUT_FILENO);
  ::execve(program, arguments, variables);
  ::_exit(127);
}

bool write_all(const int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(file, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return true;
}

struct Reply {
  int code;
  bool goes_on;
};

/// What a worker replies; nothing if it has ended instead, or writes something else.
std::optional<Reply> reply_from(const int file) {
  std::string text;
  for (;;) {
    char letter = 0;
    const ssize_t n = ::read(file, &letter, 1);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return std::nullopt;
    if (letter != '\n') {
      text += letter;
      continue;
    }
    int code = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), code);
    if (read.ec != std::errc()) return std::nullopt;
    return Reply{code, text.find(worker_goes_on) != std::string::npos};
  }
}

}  // namespace

Workers::Workers() {
  ::signal(SIGPIPE, SIG_IGN);  // a worker that has ended is noticed by its reply
}

Workers::~Workers() {
  for (const Worker& worker : workers_)
    if (worker.task.done) ::kill(worker.id, SIGTERM);
  while (!workers_.empty()) dismiss(workers_.size() - 1);
}

int Workers::dismiss(const std::size_t place) {
  const Worker worker = std::move(workers_[place]);
  workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(place));
  ::close(worker.requests);
  ::close(worker.replies);
  int status = 0;
  while (::waitpid(worker.id, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
}

std::size_t Workers::busy() const {
  return static_cast<std::size_t>(
      std::count_if(workers_.begin(), workers_.end(),
                    [](const Worker& worker) { return static_cast<bool>(worker.task.done); }));
}

Workers::Worker& Workers::idle_worker() {
  const auto idle = std::find_if(workers_.begin(), workers_.end(),
                                 [](const Worker& worker) { return !worker.task.done; });
  if (idle != workers_.end()) return *idle;
  std::string solver = base::installed_program("geneva-solver").string();
  std::string word = worker_word;
  if (::access(solver.c_str(), X_OK) != 0) base::refuse_by_system("cannot start " + solver);
  const std::array<char*, 3> arguments{solver.data(), word.data(), nullptr};
  const std::vector<char*> variables = environment_of_worker();
  Pipe requests;
  Pipe replies;
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0)
    become(solver.c_str(), arguments.data(), variables.data(), requests, replies, parent);
  if (child < 0) base::refuse_by_system("cannot start " + solver);
  workers_.push_back({child, requests.take_writing(), replies.take_reading(), {}});
  return workers_.back();
}

void Workers::start(WorkerTask task) {
  Worker& worker = idle_worker();
  std::string request;
  for (const std::filesystem::path& path : {task.case_directory, task.log})
    request += path.string() + '\0';
  worker.task = std::move(task);
  (void)write_all(worker.requests, request);
}

void Workers::wait() {
  std::vector<pollfd> files;
  for (const Worker& worker : workers_) files.push_back({worker.replies, POLLIN, 0});
  while (::poll(files.data(), files.size(), -1) < 0 && errno == EINTR) {
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].revents == 0) continue;
    const std::function<void(int)> done = std::exchange(workers_[i].task, {}).done;
    const std::optional<Reply> reply = reply_from(workers_[i].replies);
    const bool goes_on = reply && reply->goes_on && reply->code != internal_error;
    const int code_of_end = goes_on ? 0 : dismiss(i);
    const int without_reply = code_of_end == 0 ? int{internal_error} : code_of_end;
    if (done) done(reply ? reply->code : without_reply);
    return;
  }
}

}  // namespace geneva::app
