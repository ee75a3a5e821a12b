#pragma once

#include <filesystem>
#include <string>

namespace geneva::mesh {

/// A new directory among the temporary files that only this user may enter; removed at the end.
class PrivateDirectory {
 public:
  /// @throws std::runtime_error if it cannot be made
  PrivateDirectory();
  ~PrivateDirectory();
  PrivateDirectory(const PrivateDirectory&) = delete;
  PrivateDirectory& operator=(const PrivateDirectory&) = delete;
  PrivateDirectory(PrivateDirectory&&) = delete;
  PrivateDirectory& operator=(PrivateDirectory&&) = delete;

  /// Absolute, without symbolic links.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file of that name, in a directory below if the name has one, and returns its path.
  /// @throws std::runtime_error if it cannot be written
  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace geneva::mesh
