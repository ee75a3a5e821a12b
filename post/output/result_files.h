#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::post {

/// A document that a command writes, and the files that belong to it.
struct ResultFiles {
  const char* document;             ///< without its extension: "summary" is summary.json
  const char* command;              ///< that writes it
  std::vector<const char*> tables;  ///< that a report needs, without their extension csv
  std::vector<const char*> others;  ///< with their extensions
  bool is_reported;                 ///< whether a report shows it
};

/// Of all commands; with is_shared_file() the only list of the program's own files, by which they
/// are written, read and removed.
const std::vector<ResultFiles>& result_files();

/// Files that several commands write, each anew: the mechanism's picture and the report.
bool is_shared_file(const std::string& name);

/// Whether a file belongs to a document, its own one included.
bool belongs_to(const ResultFiles& files, const std::string& name);

/// A file that the program may write into a results directory, since it will remove it again.
/// @throws std::logic_error if it is not among its own files
std::filesystem::path own_file(const std::filesystem::path& directory, const std::string& name);

}  // namespace geneva::post
