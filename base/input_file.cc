#include "base/input_file.h"

#include <fstream>
#include <sstream>

namespace geneva::base {

std::string bytes_of(const std::filesystem::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  if (stream) bytes << stream.rdbuf();
  return bytes.str();
}

}  // namespace geneva::base
