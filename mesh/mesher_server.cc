#include "mesh/mesher_server.h"

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
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "mesh/descriptor_exchange.h"

namespace geneva::mesh {

namespace {

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
  Descriptor own;
  Descriptor others;
};

Ends new_socket() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    fail_to("cannot make a socket for the mesher");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Ends new_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to("cannot make a pipe for the mesher");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
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

/// Whether there is something to read before the time is over.
bool is_ready(const Descriptor& from, const std::chrono::steady_clock::time_point deadline) {
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        deadline - std::chrono::steady_clock::now());
    pollfd watched{from.get(), POLLIN, 0};
    const int ready = poll(&watched, 1, std::max(0, static_cast<int>(left.count())));
    if (ready >= 0 || errno != EINTR) return ready > 0;
  }
}

/// What has been printed so far, the end of it.
std::string printed(const Descriptor& messages) {
  constexpr std::size_t kept = 4096;
  std::string text;
  std::array<char, kept> buffer{};
  while (is_ready(messages, std::chrono::steady_clock::now())) {
    const ssize_t count = ::read(messages.get(), buffer.data(), buffer.size());
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > kept) text.erase(0, text.size() - kept);
  }
  return text;
}

std::string in_words(const int status) {
  return WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                             : fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

MesherServer::MesherServer(const std::filesystem::path& program) : program_(program) { start(); }

MesherServer::~MesherServer() { stop(); }

void MesherServer::start() {
  Ends control = new_socket();
  Ends print = new_pipe();
  id_ = spawn(program_, control.others.get(), print.others.get());
  if (id_ <= 0)
    fail_to(fmt::format("the mesher {}, which belongs beside geneva, cannot be started",
                        program_.string()));
  control_ = std::move(control.own);
  messages_ = std::move(print.own);
}

std::string MesherServer::stop() {
  constexpr auto moment = std::chrono::milliseconds(20);
  if (id_ <= 0) return "";
  int status = 0;
  pid_t ended = 0;
  // One that has closed its end of the socket may need a moment to go.
  for (int i = 0; i < 5 && ended == 0; ++i) {
    if (i > 0) std::this_thread::sleep_for(moment);
    ended = waitpid(id_, &status, WNOHANG);
    if (!is_ready(control_, std::chrono::steady_clock::now())) break;
  }
  std::string end;
  if (ended == id_) {
    const std::string last = last_line(printed(messages_));
    end = in_words(status) + (last.empty() ? "" : ": " + last);
  } else {
    kill(id_, SIGKILL);
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  id_ = -1;
  control_.close();
  messages_.close();
  return end;
}

std::optional<MesherProcess> MesherServer::copy(const double seconds) {
  // Beyond a day no clock is needed, and milliseconds would overflow.
  constexpr double day = 86400.;
  const auto deadline = std::chrono::steady_clock::now() +
                        std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                            std::chrono::duration<double>(std::min(seconds, day)));
  Ends talk = new_socket();
  Ends print = new_pipe();
  if (send_descriptors(control_.get(), {talk.others.get(), print.others.get()})) {
    const bool has_answered = is_ready(control_, deadline);
    const auto id = has_answered ? receive_process_id(control_.get()) : std::nullopt;
    if (id && *id > 0) return MesherProcess(*id, std::move(talk.own), std::move(print.own));
    trouble_ = !has_answered ? ""
               : id          ? fmt::format("cannot make a process: {}", std::strerror(-*id))
                             : "has ended";
  }
  const std::string end = stop();
  if (!trouble_.empty() && !end.empty()) trouble_ = end;
  return std::nullopt;
}

std::optional<MesherProcess> MesherServer::process(const double seconds) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (id_ <= 0) start();
    trouble_ = "has ended";
    if (auto process = copy(seconds)) return process;
    if (trouble_.empty()) return std::nullopt;
  }
  throw base::InputError(
      fmt::format("the mesher {}, which belongs beside geneva, {}", program_.string(), trouble_));
}

}  // namespace geneva::mesh
