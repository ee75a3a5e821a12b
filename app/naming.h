#pragma once

#include <stdexcept>
#include <string>

#include "app/case_file.h"

namespace geneva::app {

/// Runs a task and puts the case file's name before what it says against the case, unless a file is
/// named already.
template <typename Task>
auto naming(const Case& given, const Task& task) {
  try {
    return task();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    if (text.find(given.directory.string()) != std::string::npos) throw;
    throw std::invalid_argument((given.directory / "case.prm").string() + ": " + text);
  }
}

}  // namespace geneva::app
