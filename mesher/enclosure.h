#pragma once

#include <string>

#include "mesh/mesher_exchange.h"

namespace geneva::mesher {

/// Lets this process use no more than the limits beside what it has already; the system ends it, or
/// refuses memory, beyond.
void limit(const mesh::MesherLimits& limits);

/// Takes every right from this process that meshing does not need, for good: it can open files of
/// one directory for reading only, start nothing, reach no network and gain no privilege.
/// @param directory absolute; empty: no file at all
/// @return whether the system can do all of that (Landlock, seccomp)
bool enclose(const std::string& directory);

}  // namespace geneva::mesher
