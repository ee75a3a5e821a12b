#include "mesh/geometry_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

/// What commands of Gmsh's language would do that none may; null for all other words.
const char* harm_of(const std::string_view word) {
  static const char* const runs = "it runs a command on this machine";
  static const char* const writes = "it writes to a file or directory";
  static const char* const stops = "it ends the program";
  static const std::map<std::string_view, const char*> words{
      {"SystemCall", runs},  {"NonBlockingSystemCall", runs},
      {"System", runs},      {"OnelabRun", runs},
      {"Print", writes},     {"Save", writes},
      {"CreateDir", writes}, {"SendToServer", writes},
      {"Exit", stops},       {"Abort", stops},
      {"Sleep", "it waits"}};
  const auto found = words.find(word);
  return found == words.end() ? nullptr : found->second;
}

bool is_part_of_word(const char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Index after a comment or text that begins there; the same index if none does.
std::size_t after_comment_or_text(const std::string& content, const std::size_t begin) {
  const auto after = [&](const char* const end, const std::size_t from) {
    const std::size_t found = content.find(end, from);
    return found == content.npos ? content.size() : found + std::string_view(end).size();
  };
  if (content.compare(begin, 2, "//") == 0) return after("\n", begin) - 1;
  if (content.compare(begin, 2, "/*") == 0) return after("*/", begin + 2);
  if (content[begin] == '"') return after("\"", begin + 1);
  if (content[begin] == '\'') return after("'", begin + 1);
  return begin;
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw base::InputError(fmt::format("{}: there is no such file", file.string()));
  if (!std::filesystem::is_regular_file(file))
    throw base::InputError(fmt::format("{}: this is not a file", file.string()));
  if (std::filesystem::file_size(file) > largest_file)
    throw base::InputError(
        fmt::format("{}: the file is larger than {} MiB: a coarse mesh is all that is needed, it "
                    "is refined while solving",
                    file.string(), largest_file >> 20));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw base::InputError(fmt::format("{}: the file cannot be read", file.string()));
  return content.str();
}

std::vector<std::string> check_geometry(const std::string& content,
                                        const std::filesystem::path& file) {
  std::vector<std::string> names;
  int line = 1;
  std::size_t at = 0;
  const auto go_to = [&](const std::size_t next) {
    for (; at < next; ++at)
      if (content[at] == '\n') ++line;
  };
  bool reads_a_file = false;
  while (at < content.size()) {
    if (const std::size_t next = after_comment_or_text(content, at); next != at) {
      const bool is_text = content[at] != '/';
      if (is_text && reads_a_file) names.push_back(content.substr(at + 1, next - at - 2));
      if (is_text) reads_a_file = false;
      go_to(next);
      continue;
    }
    std::size_t end = at;
    while (end < content.size() && is_part_of_word(content[end])) ++end;
    const std::string word = content.substr(at, end - at);
    if (const char* const harm = harm_of(word); harm != nullptr)
      throw base::InputError(fmt::format(
          "{}:{}: '{}' is refused: {}; a geometry may draw, mesh, calculate, print to the terminal "
          "and read files of its own directory",
          file.string(), line, word, harm));
    if (!word.empty()) reads_a_file = word == "Include" || word == "Merge";
    go_to(std::max(end, at + 1));
  }
  const std::string last = content.substr(content.find_last_of('\n') + 1);
  if (last.find_first_not_of(" \t\r") != last.npos)
    throw base::InputError(
        fmt::format("{}:{}: the last line has no end, and Gmsh would leave out what stands there: "
                    "add a line feed",
                    file.string(), line));
  return names;
}

void check_geometry_files(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> to_do{file};
  std::set<std::filesystem::path> seen;
  while (!to_do.empty()) {
    const std::filesystem::path next = to_do.back();
    to_do.pop_back();
    if (!seen.insert(next.lexically_normal()).second) continue;
    for (const std::string& name : check_geometry(read_file(next), next)) {
      const std::filesystem::path read = next.parent_path() / name;
      // Of others Gmsh says what is wrong.
      std::error_code ignored;
      if (read.extension() == ".geo" && std::filesystem::is_regular_file(read, ignored))
        to_do.push_back(read);
    }
  }
}

}  // namespace geneva::mesh
