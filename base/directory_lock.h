#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/undo.h"

namespace geneva::base {

/// A lock that one process at a time holds, by a file with its number; the file goes with the lock,
/// and one that a dead process left does not lock.
class DirectoryLock {
 public:
  /// @param file in a directory that exists and can be written to
  /// @param guarded what it is for, as the message calls it
  /// @throws InputError if another process holds it, naming the process, or if the file cannot be
  /// made
  DirectoryLock(std::filesystem::path file, const std::string& guarded);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_;
  std::optional<Undo> undo_;
};

}  // namespace geneva::base
