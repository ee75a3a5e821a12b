#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/reader.h"

// Gives files to a reader once each, for compilers without libFuzzer: replay FILE...

namespace {

/// Whether the reader takes it or refuses it as it should.
bool is_read(const std::string& name) {
  std::ifstream stream(name, std::ios::binary);
  const std::vector<char> content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open()) {
    std::cerr << name << ": cannot be read\n";
    return false;
  }
  const std::vector<std::uint8_t> bytes(content.begin(), content.end());
  try {
    return LLVMFuzzerTestOneInput(bytes.data(), bytes.size()) == 0;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return false;
  }
}

}  // namespace

int main(const int argc, char** const argv) {
  const std::vector<std::string> files(argv + 1, argv + argc);
  if (files.empty()) {
    std::cerr << "there are no files\n";
    return 1;
  }
  int failed = 0;
  for (const std::string& file : files)
    if (!is_read(file)) ++failed;
  std::cout << files.size() << " files, " << failed << " findings\n";
  return failed == 0 ? 0 : 1;
}
