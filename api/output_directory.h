#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "api/written.h"
#include "base/directory_replacement.h"
#include "model/input/case_file.h"

namespace geneva::api {

/// Writes a document and the files that belong to it into a results directory, which is replaced as
/// a whole, without what the program wrote there before: of the same document and of other cases.
/// Documents of the same case (content_of()) stay with their files; so do files that are not the
/// program's own, and those that the case reads. All but a synthesis get a report.
/// @param document as in result_files(): "kinematics"
/// @param texts of the files by their names
/// @throws base::InputError if something cannot be written; the directory is then as it was
Written write_results(const std::filesystem::path& directory, const model::Case& given,
                      const std::string& document, const std::map<std::string, std::string>& texts);

/// A results directory that is replaced only when everything has been written.
///
/// Rank 0 owns it; the others only know its name.
class OutputDirectory {
 public:
  /// @param final where the results go
  /// @param document that is going to be written there, as in result_files()
  /// @param is_owner whether this rank makes, fills and removes directories
  /// @throws base::InputError if the directory cannot be replaced, or another run does so
  OutputDirectory(const std::filesystem::path& final, const model::Case& given,
                  std::string document, bool is_owner);

  /// Where its files are written.
  [[nodiscard]] const std::filesystem::path& working() const { return working_; }
  /// @param size of what is going to be written [byte]
  /// @throws base::InputError if the owner's disk has less
  void check_space(double size) const;
  /// Does what write_results() does when all files are in working().
  Written publish();

 private:
  model::Case given_;
  std::string document_;
  std::filesystem::path working_;
  std::optional<base::DirectoryReplacement> replacement_;  ///< of the owner
};

}  // namespace geneva::api
