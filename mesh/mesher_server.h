#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "mesh/descriptor.h"
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

  /// A process for one task. A program that has ended is started once more.
  /// @param seconds that it may take at most
  /// @return nothing if it takes longer
  /// @throws base::InputError if there is none, with the reason
  std::optional<MesherProcess> process(double seconds);

 private:
  void start();
  /// @return how it ended, if it had; empty: it ran
  std::string stop();
  /// @return none: see trouble_
  std::optional<MesherProcess> copy(double seconds);

  std::filesystem::path program_;
  pid_t id_ = -1;
  Descriptor control_;
  Descriptor messages_;
  std::string trouble_;  ///< of the last copy that could not be made; empty: it took too long
};

}  // namespace geneva::mesh
