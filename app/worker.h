#pragma once

#include <filesystem>
#include <functional>

namespace geneva::app {

/// Solves cases that another process names (Workers), one after the other, until it names no more.
/// Reads from standard input the directory of a case and the file of its log, each ended by a zero;
/// answers on what was standard output with the exit code, whether it goes on
/// (worker_goes_on) or has kept too much memory, and a new line.
/// @param run solves one case
/// @return exit code
int work(const std::function<int(const std::filesystem::path&)>& run);

}  // namespace geneva::app
