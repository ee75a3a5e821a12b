#pragma once

#include <optional>

#include "app/command_line.h"
#include "mesh/mesher.h"

namespace geneva::app {

/// Whether it meshes.
bool needs_mesher(const Request& request);

/// A mesher for a request that needs one, on the process that the launcher of MPI programs, if
/// there is one, will make the first rank.
/// @throws base::InputError if the mesher cannot be started
std::optional<mesh::Mesher> early_mesher(const Request& request);

}  // namespace geneva::app
