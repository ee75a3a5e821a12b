#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace geneva::post {

/// Opens a file for writing. @throws std::runtime_error naming it if that fails
inline std::ofstream open_output(const std::filesystem::path& file) {
  std::ofstream stream(file);
  if (!stream) throw std::runtime_error("cannot write " + file.string());
  return stream;
}

/// Closes a file that was written. @throws std::runtime_error naming it if not everything arrived
inline void close_output(std::ofstream& stream, const std::filesystem::path& file) {
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot write all of " + file.string() + ": is the disk full?");
}

}  // namespace geneva::post
