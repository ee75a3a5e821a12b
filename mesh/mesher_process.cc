#include "mesh/mesher_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/printable.h"

namespace geneva::mesh {

namespace {

using Clock = std::chrono::steady_clock;

/// Of what a program prints no more than the end is kept.
constexpr std::size_t kept_messages = 4096;

[[noreturn]] void fail(const std::string& what) {
  throw base::InputError(fmt::format("{}: {}", what, std::strerror(errno)));
}

/// What finds and tries out the program's libraries, and nothing that a user has set for others.
std::vector<std::string> environment() {
  std::vector<std::string> variables{"LC_ALL=C", "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"};
  for (const char* const name : {"LD_LIBRARY_PATH", "LD_PRELOAD", "ASAN_OPTIONS", "UBSAN_OPTIONS"})
    if (const char* const value = std::getenv(name))
      variables.push_back(std::string(name) + "=" + value);
  return variables;
}

/// Ends of a connection that children do not inherit unless they are given one.
struct Ends {
  int own;
  int others;
};

Ends new_socket() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    fail("cannot make a socket for the mesher");
  return {ends[0], ends[1]};
}

Ends new_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe for the mesher");
  return {ends[0], ends[1]};
}

pid_t spawn(const std::filesystem::path& program, const int input, const int messages) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  sigset_t none;
  sigset_t all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = program.string();
  std::vector<std::string> variables = environment();
  std::vector<char*> pointers;
  for (std::string& variable : variables) pointers.push_back(variable.data());
  pointers.push_back(nullptr);
  std::array<char*, 2> arguments{name.data(), nullptr};
  pid_t id = -1;
  errno = posix_spawn(&id, name.c_str(), &actions, &attributes, arguments.data(), pointers.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return errno == 0 ? id : -1;
}

/// Milliseconds until then, at least 0, at most what poll() takes.
int milliseconds_until(const Clock::time_point end) {
  const auto left = std::chrono::duration<double, std::milli>(end - Clock::now()).count();
  return static_cast<int>(std::clamp(std::ceil(left), 0., 1e9));
}

/// Appends what there is to read.
/// @return false at the end
bool read_some(const int from, std::string& to) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(from, buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  to.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n \t");
  if (end == text.npos) return "";
  const std::size_t begin = text.find_last_of("\r\n", end);
  std::string line = text.substr(begin == text.npos ? 0 : begin + 1, end + 1);
  line = line.substr(0, line.find_last_not_of("\r\n \t") + 1);
  return base::printable(line);
}

}  // namespace

MesherProcess::MesherProcess(const std::filesystem::path& program) {
  const Ends talk = new_socket();
  socket_ = talk.own;
  const Ends print = new_pipe();
  messages_ = print.own;
  id_ = spawn(program, talk.others, print.others);
  const int error = errno;
  close(talk.others);
  close(print.others);
  if (id_ > 0) return;
  close_all();
  errno = error;
  fail(fmt::format("the mesher {}, which belongs beside geneva, cannot be started",
                   program.string()));
}

MesherProcess::MesherProcess(MesherProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      messages_(std::exchange(other.messages_, -1)) {}

MesherProcess::~MesherProcess() {
  if (id_ > 0) end();
  close_all();
}

void MesherProcess::close_all() {
  for (int* const descriptor : {&socket_, &messages_})
    if (*descriptor >= 0) close(std::exchange(*descriptor, -1));
}

/// @return the signal that ended it before; 0: none
int MesherProcess::end() {
  kill(id_, SIGKILL);  // one that has ended keeps what ended it
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  return WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL ? WTERMSIG(status) : 0;
}

ProcessEnd MesherProcess::ask(const std::string& request, const double seconds,
                              const std::size_t longest) {
  // Beyond a year no clock is needed, and it would overflow.
  constexpr double year = 3.2e7;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(std::min(seconds, year)));
  ProcessEnd result{"", "", 0, false};
  std::string messages;
  std::size_t sent = 0;
  bool prints = true;
  while (true) {
    std::array<pollfd, 2> watched{
        pollfd{socket_, static_cast<short>(sent < request.size() ? POLLIN | POLLOUT : POLLIN), 0},
        pollfd{prints ? messages_ : -1, POLLIN, 0}};
    const int ready = poll(watched.data(), watched.size(), milliseconds_until(deadline));
    if (ready < 0 && errno != EINTR) fail("cannot wait for the mesher");
    result.took_too_long = Clock::now() >= deadline;
    if (result.took_too_long) break;
    if (ready <= 0) continue;
    if ((watched[1].revents & (POLLIN | POLLHUP)) != 0) {
      prints = read_some(messages_, messages);
      if (messages.size() > kept_messages) messages.erase(0, messages.size() - kept_messages);
    }
    if ((watched[0].revents & POLLOUT) != 0) {
      const ssize_t count =
          send(socket_, request.data() + sent, request.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
      // Of one that has gone only what it said is of interest.
      sent = count < 0 && errno != EAGAIN && errno != EINTR
                 ? request.size()
                 : sent + static_cast<std::size_t>(std::max<ssize_t>(count, 0));
      if (sent == request.size()) shutdown(socket_, SHUT_WR);
    }
    if ((watched[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0 &&
        (!read_some(socket_, result.output) || result.output.size() > longest))
      break;
  }
  result.signal = end();
  while (prints && read_some(messages_, messages)) {
  }
  result.last_message = last_line(messages);
  close_all();
  return result;
}

}  // namespace geneva::mesh
