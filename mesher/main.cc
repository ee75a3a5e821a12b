#include <fcntl.h>
#include <gmsh.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "mesh/descriptor_exchange.h"
#include "mesh/mesher_exchange.h"
#include "mesher/enclosure.h"
#include "mesher/geometry_reader.h"
#include "mesher/outline_mesher.h"

// Waits on its standard input, a socket, for tasks and makes a copy of itself for each: that one
// may have to run what a stranger has written, so it gives up every right that it does not need
// before.

namespace {

using namespace geneva;
using nlohmann::json;

std::string all_of(const int descriptor) {
  std::string text;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void send(const int descriptor, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = write(descriptor, text.data() + sent, text.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

/// The socket, in whose place nothing can be read.
int own_socket() {
  const int socket = dup(STDIN_FILENO);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  close(nothing);
  return socket;
}

template <int dim>
json reading_of(const mesh::GeometryTask& task) {
  const mesher::Reading<dim> reading = mesher::read_geometry<dim>(task);
  if (!reading.errors.empty()) return {{"errors", reading.errors}};
  return {{"mesh", mesh::json_of(reading.mesh)}};
}

json result_of(const json& task) {
  if (task.contains("outlines")) {
    const mesh::OutlineTask outlines = mesh::outline_task_of(task);
    return {{"mesh", mesh::json_of(mesher::mesh_outlines(outlines.outlines, outlines.sizing))}};
  }
  const mesh::GeometryTask geometry = mesh::geometry_task_of(task);
  return geometry.dimension == 2 ? reading_of<2>(geometry) : reading_of<3>(geometry);
}

json answer_to(const json& request) {
  const json& task = request.at("task");
  const json& limits = request.at("limits");
  mesher::limit({limits.at("memory").get<double>(), limits.at("seconds").get<double>()});
  const bool is_enclosed = mesher::enclose(task.value("directory", ""));
  json answer = json::object();
  try {
    answer = result_of(task);
  } catch (const std::bad_alloc&) {
    answer = {{"out_of_memory", true}};
  } catch (const std::exception& error) {
    answer = {{"errors", {error.what()}}};
  }
  answer["is_enclosed"] = is_enclosed;
  answer["gmsh_version"] = GMSH_API_VERSION;
  return answer;
}

/// A copy of this process with the same parent, which can wait for it and learns how it ended.
/// @return 0 in the copy, there its number
pid_t copied_process() {
  return static_cast<pid_t>(
      syscall(SYS_clone, CLONE_PARENT | SIGCHLD, nullptr, nullptr, nullptr, nullptr));
}

/// What escapes ends the process, and geneva says so.
[[noreturn]] void serve(const mesh::TaskDescriptors& task, const pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before this could know
  dup2(task.messages, STDOUT_FILENO);
  dup2(task.messages, STDERR_FILENO);
  const int socket = dup2(task.talk, STDERR_FILENO + 1);
  close_range(static_cast<unsigned int>(socket) + 1, ~0U, 0);
  const std::string request = all_of(socket);
  const json answer = answer_to(json::parse(request));
  send(socket, answer.dump(-1, ' ', false, json::error_handler_t::replace));
  // Gmsh's own end takes time, and may not work any more.
  _exit(0);
}

}  // namespace

int main() {  // NOLINT(bugprone-exception-escape)
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int control = own_socket();
  close_range(static_cast<unsigned int>(control) + 1, ~0U, 0);
  (void)setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  while (const auto task = mesh::receive_descriptors(control)) {
    const pid_t parent = getppid();
    const pid_t copy = copied_process();
    if (copy == 0) serve(*task, parent);
    const pid_t answer = copy < 0 ? -errno : copy;
    close(task->talk);
    close(task->messages);
    if (!mesh::send_process_id(control, answer)) return 1;
  }
}
