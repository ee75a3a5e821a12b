#pragma once

#include <filesystem>

#include "model/input/starter_case.h"

namespace geneva::app {

/// `geneva init`: writes a new case and says how to go on.
/// @return exit code 0
/// @throws base::InputError if the type or number of stations is none, or the directory holds a
/// case already; nothing is written then
int init_case(const std::filesystem::path& directory, const model::Starter& starter);

}  // namespace geneva::app
