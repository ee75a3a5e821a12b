#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesher_exchange.h"
#include "mesh/mesher_server.h"

namespace geneva::mesh {

/// Where the mesher lies, see base::installed_program().
/// @throws base::InputError if it lies nowhere, with the places that were looked at
std::filesystem::path installed_mesher();

/// Gmsh in a process of its own: it runs what a stranger may have written, and may crash, run on or
/// lie without harm to this one.
///
/// One process serves one task, a copy of one that is started at once and gets ready while this
/// program does. Used on one rank, without MPI.
class Mesher {
 public:
  /// @param program see installed_mesher()
  explicit Mesher(const std::filesystem::path& program);

  /// The mesh of outlines or of a geometry.
  /// @return what it says in place of a mesh, if it refuses, fails or crashes: Gmsh's errors, or
  /// how it ended with the last that it said
  /// @throws base::LimitReached if it takes more than it may
  /// @throws base::InputError if it cannot be started
  template <typename Task>
  MesherAnswer answer(const Task& task, const MesherLimits& limits) {
    return answer_to(json_of(task), limits);
  }

  /// Of the last answer: whether the system kept the mesher from files, processes and networks.
  [[nodiscard]] bool was_enclosed() const { return was_enclosed_; }
  /// Of the last answer.
  [[nodiscard]] const std::string& gmsh_version() const { return gmsh_version_; }

 private:
  MesherAnswer answer_to(const nlohmann::json& task, const MesherLimits& limits);

  std::unique_ptr<MesherServer> server_;
  bool was_enclosed_ = true;
  std::string gmsh_version_;
};

}  // namespace geneva::mesh
