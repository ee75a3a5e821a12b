#include "mesh/private_directory.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace geneva::mesh {

PrivateDirectory::PrivateDirectory() {
  const std::string to_be_replaced(6, 'X');  // what mkdtemp wants at the end of its pattern
  std::string pattern = (std::filesystem::temp_directory_path() / "geneva-").string();
  pattern += to_be_replaced;
  if (mkdtemp(pattern.data()) == nullptr)
    throw std::runtime_error(
        fmt::format("cannot make the temporary directory {}: {}", pattern, std::strerror(errno)));
  path_ = std::filesystem::canonical(pattern);
}

PrivateDirectory::~PrivateDirectory() {
  std::error_code ignored;  // what cannot be removed is left to the system
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path PrivateDirectory::write(const std::string& name,
                                              const std::string& content) const {
  std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
  return file;
}

}  // namespace geneva::mesh
