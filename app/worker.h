#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>

namespace geneva::app {

/// Solves cases that another process names (Workers), one after the other, until it names no more.
/// Reads from standard input the directory of a case and the file of its log, each ended by a zero;
/// answers on what was standard output with the exit code, whether it goes on
/// (worker_goes_on) or has kept too much memory, and a new line.
/// @param replies to the other process, as take_replies() gives it
/// @param run solves one case
/// @return exit code
int work(std::FILE* replies, const std::function<int(const std::filesystem::path&)>& run);

/// Standard output for replies alone; what else is printed there from now on goes to standard
/// error.
/// @throws base::InputError if there is none
std::FILE* take_replies();

}  // namespace geneva::app
