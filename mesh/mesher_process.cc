#include "mesh/mesher_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/errors.h"
#include "base/printable.h"

namespace geneva::mesh {

namespace {

using Clock = std::chrono::steady_clock;

/// Of what a program prints no more than the end is kept.
constexpr std::size_t kept_messages = 4096;

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

}  // namespace

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n \t");
  if (end == text.npos) return "";
  const std::size_t begin = text.find_last_of("\r\n", end);
  std::string line = text.substr(begin == text.npos ? 0 : begin + 1, end + 1);
  line = line.substr(0, line.find_last_not_of("\r\n \t") + 1);
  return base::printable(line);
}

MesherProcess::MesherProcess(MesherProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      socket_(std::move(other.socket_)),
      messages_(std::move(other.messages_)) {}

MesherProcess::~MesherProcess() {
  if (id_ > 0) end();
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
        pollfd{socket_.get(), static_cast<short>(sent < request.size() ? POLLIN | POLLOUT : POLLIN),
               0},
        pollfd{prints ? messages_.get() : -1, POLLIN, 0}};
    const int ready = poll(watched.data(), watched.size(), milliseconds_until(deadline));
    if (ready < 0 && errno != EINTR)
      throw base::InputError(fmt::format("cannot wait for the mesher: {}", std::strerror(errno)));
    result.took_too_long = Clock::now() >= deadline;
    if (result.took_too_long) break;
    if (ready <= 0) continue;
    if ((watched[1].revents & (POLLIN | POLLHUP)) != 0) {
      prints = read_some(messages_.get(), messages);
      if (messages.size() > kept_messages) messages.erase(0, messages.size() - kept_messages);
    }
    if ((watched[0].revents & POLLOUT) != 0) {
      const ssize_t count = send(socket_.get(), request.data() + sent, request.size() - sent,
                                 MSG_NOSIGNAL | MSG_DONTWAIT);
      // Of one that has gone only what it said is of interest.
      sent = count < 0 && errno != EAGAIN && errno != EINTR
                 ? request.size()
                 : sent + static_cast<std::size_t>(std::max<ssize_t>(count, 0));
      if (sent == request.size()) shutdown(socket_.get(), SHUT_WR);
    }
    if ((watched[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0 &&
        (!read_some(socket_.get(), result.output) || result.output.size() > longest))
      break;
  }
  result.signal = end();
  while (prints && read_some(messages_.get(), messages)) {
  }
  result.last_message = last_line(messages);
  socket_.close();
  messages_.close();
  return result;
}

}  // namespace geneva::mesh
