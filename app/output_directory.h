#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::app {

/// A path as the user would write it: relative where it lies below the current directory.
std::string shown_path(const std::filesystem::path& path);

/// Tells before long work whether its results can be written: makes nothing.
/// @throws std::invalid_argument if the directory cannot be made or written to
void check_writable(const std::filesystem::path& directory);

/// Writes one file under a hidden name and renames it; makes its directory.
/// @throws std::invalid_argument if the directory cannot be made or written to; std::runtime_error
/// if not everything could be written
void write_and_rename(const std::filesystem::path& file, const std::string& text);

/// A results directory that is replaced only when everything has been written.
///
/// Files are written into a hidden directory beside the final one and moved over by publish(); what
/// an earlier run of this program left and this one did not write is removed then, other files
/// stay. Without publish() the destructor removes the hidden directory and the final one is as it
/// was. Rank 0 owns it; the others only know its name.
class OutputDirectory {
 public:
  /// @param final where the results go
  /// @param is_owner whether this rank makes, fills and removes directories
  /// @throws std::invalid_argument if the directory cannot be made or written to
  OutputDirectory(const std::filesystem::path& final, bool is_owner);
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;
  ~OutputDirectory();

  [[nodiscard]] const std::filesystem::path& working() const { return working_; }
  [[nodiscard]] const std::filesystem::path& final() const { return final_; }
  void publish();

 private:
  std::filesystem::path final_;
  std::filesystem::path working_;
  std::vector<std::filesystem::path> made_;  ///< parents that did not exist, deepest first
  bool is_owner_;
};

}  // namespace geneva::app
