#include "app/case_content.h"

#include <fmt/format.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/crc.hpp>
#include <fstream>
#include <iterator>
#include <sstream>

namespace geneva::app {

namespace {

/// CRC-64 of ECMA-182 with the conventions of XZ.
using Checksum = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true>;

void add(Checksum& sum, const std::string& text) { sum.process_bytes(text.data(), text.size()); }

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string content_of(const std::string& completed, const std::string& model,
                       const std::vector<std::filesystem::path>& inputs) {
  Checksum sum;
  add(sum, model + '\n');
  std::istringstream lines(completed);
  std::string section;  // the outermost one
  int depth = 0;
  for (std::string line; std::getline(lines, line);) {
    line = boost::algorithm::trim_copy(line.substr(0, line.find('#')));
    if (line.rfind("subsection ", 0) == 0 && depth++ == 0) section = line.substr(11);
    const bool is_models = depth > 0 && boost::algorithm::to_lower_copy(section) == model;
    if (!line.empty() && is_models) add(sum, line + '\n');
    if (line == "end") --depth;
  }
  for (const std::filesystem::path& file : inputs) add(sum, bytes_of(file));
  return fmt::format("{:016x}", sum.checksum());
}

}  // namespace geneva::app
