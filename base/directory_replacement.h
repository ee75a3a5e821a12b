#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/directory_lock.h"
#include "base/undo.h"

namespace geneva::base {

/// A directory that is replaced as a whole, by one rename, or not at all.
///
/// Its files are written into a hidden directory beside it; commit() exchanges the two. What an
/// interruption leaves is put in order by the next replacement. One process at a time.
class DirectoryReplacement {
 public:
  /// @throws InputError if the directory cannot be replaced, or is being replaced by another
  /// process
  explicit DirectoryReplacement(const std::filesystem::path& final);
  /// Without commit() everything is as it was.
  ~DirectoryReplacement();
  DirectoryReplacement(const DirectoryReplacement&) = delete;
  DirectoryReplacement& operator=(const DirectoryReplacement&) = delete;

  /// Where the new files are written.
  [[nodiscard]] const std::filesystem::path& working() const { return working_; }
  /// Absolute, without links.
  [[nodiscard]] const std::filesystem::path& final() const { return final_; }

  /// Puts files of the old directory into the new one that are not written anew.
  /// @param is_kept by the name of a file
  /// @throws InputError if one cannot be read
  void keep(const std::function<bool(const std::string&)>& is_kept) const;
  /// Puts the new directory in the place of the old one; what is not a file there (directories,
  /// links) moves over.
  /// @throws InputError if something cannot be written; the old directory is then as it was
  void commit();

 private:
  void begin();
  void mend() const;
  void put_away(const std::filesystem::path& old) const;
  void make_parents();
  void remove_parents() const;
  void exchange() const;
  void finish() const;

  std::filesystem::path final_;
  std::filesystem::path working_;
  std::filesystem::path aside_;              ///< of the old one where two cannot be exchanged
  std::vector<std::filesystem::path> made_;  ///< parents that did not exist, deepest first
  std::optional<Undo> undo_parents_;
  std::optional<DirectoryLock> lock_;
  std::optional<Undo> undo_;
};

/// The place that a path stands for, with the links on the way followed.
/// @throws InputError if a link leads nowhere or to itself
std::filesystem::path resolved(const std::filesystem::path& path);

/// A hidden file or directory beside a resolved one: ".NAME.WHAT".
std::filesystem::path beside(const std::filesystem::path& final, const std::string& what);

/// Where the files of a replacement are written.
/// @throws InputError as resolved()
std::filesystem::path working_directory_of(const std::filesystem::path& final);

/// Tells whether a directory can be replaced, or made: makes nothing.
/// @throws InputError if not
void check_replaceable(const std::filesystem::path& directory);

}  // namespace geneva::base
