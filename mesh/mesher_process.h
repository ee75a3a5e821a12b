#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <utility>

#include "mesh/descriptor.h"

namespace geneva::mesh {

/// How a program ended, and what it said.
struct ProcessEnd {
  std::string output;        ///< all that it answered
  std::string last_message;  ///< last line of what it printed, without control characters
  int signal;                ///< that ended it; 0: it ended by itself
  bool took_too_long;
};

/// The last line of what a program printed that is not empty, without control characters.
std::string last_line(const std::string& text);

/// A process that reads a request from one end of a socket, answers to it and ends; what it prints
/// is kept apart.
class MesherProcess {
 public:
  /// @param id of a child of this process
  MesherProcess(pid_t id, Descriptor socket, Descriptor messages)
      : id_(id), socket_(std::move(socket)), messages_(std::move(messages)) {}
  /// Ends it.
  ~MesherProcess();
  MesherProcess(MesherProcess&& other) noexcept;
  MesherProcess& operator=(MesherProcess&&) = delete;
  MesherProcess(const MesherProcess&) = delete;
  MesherProcess& operator=(const MesherProcess&) = delete;

  /// Sends the request, waits for the whole answer and ends the process.
  /// @param seconds that it may take at most
  /// @param longest answer [byte]; a longer one is cut there
  ProcessEnd ask(const std::string& request, double seconds, std::size_t longest);

 private:
  int end();

  pid_t id_;
  Descriptor socket_;
  Descriptor messages_;
};

}  // namespace geneva::mesh
