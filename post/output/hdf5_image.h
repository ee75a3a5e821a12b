#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace geneva::post {

/// An HDF5 file that is made in memory and written in one piece: the HDF5 library does not survive
/// a disk that fails it.
class Hdf5Image {
 public:
  /// @throws std::bad_alloc, like all others, if the library has no memory left
  Hdf5Image();
  ~Hdf5Image();
  Hdf5Image(const Hdf5Image&) = delete;
  Hdf5Image& operator=(const Hdf5Image&) = delete;

  void add_group(const std::string& name);
  /// Rows of numbers, to be filled by fill().
  /// @param name with the groups it lies in: "history/cells"
  /// @param columns 0: a plain list
  template <typename Number>
  void add_table(const std::string& name, std::size_t rows, std::size_t columns);
  /// @param values of whole rows, by rows
  template <typename Number>
  void fill(const std::string& name, std::size_t first_row, const std::vector<Number>& values);
  /// The file, as it is now. @throws base::InputError if it cannot be written
  void write(const std::filesystem::path& file) const;

 private:
  class Handle;
  std::unique_ptr<Handle> access_;
  std::unique_ptr<Handle> file_;
};

}  // namespace geneva::post
