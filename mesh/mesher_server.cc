#include "mesh/mesher_server.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "mesh/descriptor_exchange.h"

namespace geneva::mesh {

namespace {

constexpr int longest_start = 60000;  // [ms]

[[noreturn]] void fail_to(const std::string& what) {
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
    fail_to("cannot make a socket for the mesher");
  return {ends[0], ends[1]};
}

Ends new_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to("cannot make a pipe for the mesher");
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

}  // namespace

MesherServer::MesherServer(const std::filesystem::path& program) : program_(program) {
  const Ends control = new_socket();
  control_ = control.own;
  const Ends print = new_pipe();
  messages_ = print.own;
  id_ = spawn(program, control.others, print.others);
  const int error = errno;
  close(control.others);
  close(print.others);
  if (id_ > 0) return;
  close_all();
  errno = error;
  fail_to(fmt::format("the mesher {}, which belongs beside geneva, cannot be started",
                      program.string()));
}

MesherServer::~MesherServer() {
  kill(id_, SIGKILL);
  while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
  }
  close_all();
}

void MesherServer::close_all() {
  for (int* const descriptor : {&control_, &messages_})
    if (*descriptor >= 0) close(std::exchange(*descriptor, -1));
}

void MesherServer::fail() {
  std::array<char, 4096> buffer{};
  pollfd printed{messages_, POLLIN, 0};
  const ssize_t count =
      poll(&printed, 1, 0) > 0 ? ::read(messages_, buffer.data(), buffer.size()) : 0;
  const std::string last =
      last_line({buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0});
  throw base::InputError(
      fmt::format("the mesher {}, which belongs beside geneva, {}", program_.string(),
                  last.empty() ? "ended at once or does not answer" : "ended at once: " + last));
}

MesherProcess MesherServer::process() {
  const Ends talk = new_socket();
  const Ends print = new_pipe();
  const bool sent = send_descriptors(control_, {talk.others, print.others});
  close(talk.others);
  close(print.others);
  pollfd answer{control_, POLLIN, 0};
  std::optional<pid_t> id;
  if (sent && poll(&answer, 1, longest_start) > 0) id = receive_process_id(control_);
  MesherProcess process(id.value_or(-1), talk.own, print.own);
  if (!id || *id < 0) fail();
  return process;
}

}  // namespace geneva::mesh
