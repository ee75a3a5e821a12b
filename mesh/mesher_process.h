#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace geneva::mesh {

/// How a program ended, and what it said.
struct ProcessEnd {
  std::string output;        ///< all that it answered
  std::string last_message;  ///< last line of what it printed, without control characters
  int signal;                ///< that ended it; 0: it ended by itself
  bool took_too_long;
};

/// A program that reads a request from one end of a socket, answers to it and ends; what it prints
/// is kept apart.
class MesherProcess {
 public:
  /// Starts it with nothing but the socket and few variables of the environment.
  /// @throws base::InputError if it cannot be started
  explicit MesherProcess(const std::filesystem::path& program);
  /// Ends it.
  ~MesherProcess();
  MesherProcess(MesherProcess&& other) noexcept;
  MesherProcess& operator=(MesherProcess&&) = delete;
  MesherProcess(const MesherProcess&) = delete;
  MesherProcess& operator=(const MesherProcess&) = delete;

  /// Sends the request, waits for the whole answer and ends the program.
  /// @param seconds that it may take at most
  /// @param longest answer [byte]; a longer one is cut there
  ProcessEnd ask(const std::string& request, double seconds, std::size_t longest);

 private:
  void close_all();
  int end();

  pid_t id_ = -1;
  int socket_ = -1;
  int messages_ = -1;
};

}  // namespace geneva::mesh
