#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "mesh/mesher_process.h"

namespace geneva::mesh {

/// The mesher as a program that waits: each task gets a copy of it, which finds Gmsh's hundred
/// libraries loaded already.
class MesherServer {
 public:
  /// Starts it with nothing but a socket and few variables of the environment.
  /// @throws base::InputError if it cannot be started
  explicit MesherServer(const std::filesystem::path& program);
  /// Ends it.
  ~MesherServer();
  MesherServer(const MesherServer&) = delete;
  MesherServer& operator=(const MesherServer&) = delete;

  /// A process for one task.
  /// @throws base::InputError if there is none: the program has ended, or does not answer
  MesherProcess process();

 private:
  /// @throws base::InputError with the last that it printed
  [[noreturn]] void fail();
  void close_all();

  std::filesystem::path program_;
  pid_t id_ = -1;
  int control_ = -1;
  int messages_ = -1;
};

}  // namespace geneva::mesh
