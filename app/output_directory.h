#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/case_file.h"

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

/// Writes a document and the files that belong to it into a results directory, and removes what the
/// program wrote there before: of the same document and of other cases. Documents of the same case
/// (content_of()) stay with their files; so do files that are not the program's own, and those that
/// the case reads.
/// @param document as in result_files(): "kinematics"
/// @param texts of the files by their names
/// @return names of the files removed that belonged to other documents
/// @throws std::invalid_argument and std::runtime_error where write_and_rename() does
std::vector<std::string> write_results(const std::filesystem::path& directory, const Case& given,
                                       const std::string& document,
                                       const std::map<std::string, std::string>& texts);

/// A sentence on what write_results() removed; empty if nothing was.
std::string removal_notice(const std::vector<std::string>& removed);

/// A results directory that is replaced only when everything has been written.
///
/// Files are written into a hidden directory beside the final one and moved over by publish(),
/// which removes what write_results() would. Without publish() the destructor removes the hidden
/// directory and the final one is as it was. Rank 0 owns it; the others only know its name.
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
  /// @return names of the files removed that belonged to other documents than the run's
  std::vector<std::string> publish(const Case& given);

 private:
  std::filesystem::path final_;
  std::filesystem::path working_;
  std::vector<std::filesystem::path> made_;  ///< parents that did not exist, deepest first
  bool is_owner_;
};

}  // namespace geneva::app
