#pragma once

#include <optional>

#include "app/command_line.h"
#include "mesh/mesher.h"

namespace geneva::app {

/// A mesher for a request that needs one, on the process that the launcher of MPI programs, if
/// there is one, will make the first rank.
/// @throws base::InputError if the mesher cannot be started
std::optional<mesh::Mesher> early_mesher(const Request& request);

/// Starts what early_mesher() could not foresee: for the first rank, once MPI knows it.
/// @throws as early_mesher()
void start_if_needed(const Request& request, std::optional<mesh::Mesher>& mesher);

}  // namespace geneva::app
