#include "model/input/parameter_text.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "model/input/parameter_rule.h"

namespace geneva::model {

namespace {

constexpr std::size_t largest_file = 1000000;  // bytes
constexpr std::size_t deepest_section = 2;
constexpr const char* listing_title = "# Listing of Parameters";
constexpr const char* given_mark = "# default:";  // behind what a case gave

[[noreturn]] void refuse(const std::string& file, int line, const std::string& reason) {
  throw base::InputError(fmt::format("{}, line {}: {}", file, line, reason));
}

std::string read_content(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw base::InputError(fmt::format("{}: there is no such file", name));
  if (!std::filesystem::is_regular_file(file, error))
    throw base::InputError(fmt::format("{}: this is not a file that can be read", name));
  std::ifstream stream(file, std::ios::binary);
  std::string content(largest_file + 1, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream && !stream.eof())
    throw base::InputError(fmt::format("{}: the file cannot be read", name));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  if (content.size() > largest_file)
    throw base::InputError(
        fmt::format("{}: the file is larger than 1 MB: this is no case file", name));
  return content;
}

/// A character of UTF-8 text and the bytes that it takes; none if the bytes are not UTF-8.
struct Character {
  unsigned int code = 0;
  std::size_t bytes = 0;
};

Character character_at(const std::string& text, std::size_t place) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned int first = byte(place);
  if (first < 0x80U) return {first, 1};
  const std::size_t bytes = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
  if (first < 0xC2U || first > 0xF4U || place + bytes > text.size()) return {};
  unsigned int code = first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(place + i) & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (byte(place + i) & 0x3FU);
  }
  const std::array<unsigned int, 3> least{0x80U, 0x800U, 0x10000U};
  const bool is_surrogate = code >= 0xD800U && code <= 0xDFFFU;
  if (code < least.at(bytes - 2) || code > 0x10FFFFU || is_surrogate) return {};
  return {code, bytes};
}

bool is_control(unsigned int code) {
  return (code < 0x20U && code != '\t' && code != '\n' && code != '\r') ||
         (code >= 0x7FU && code <= 0x9FU);
}

void check_characters(const std::string& text, const std::string& file) {
  int line = 1;
  for (std::size_t place = 0; place < text.size();) {
    const Character character = character_at(text, place);
    if (character.bytes == 0) refuse(file, line, "this is not UTF-8 text: save the file as UTF-8");
    if (is_control(character.code))
      refuse(file, line,
             fmt::format("the character with the code {} has no place in a text: delete it",
                         character.code));
    if (character.code == '\n') ++line;
    place += character.bytes;
  }
}

struct Line {
  std::string text;
  int number;
  bool has_mark;
};

/// Lines without comments and white space at their ends; continued ones joined.
std::vector<Line> logical_lines(const std::string& content, const std::string& file) {
  std::vector<Line> lines;
  std::istringstream stream(content);
  bool continues = false;
  int number = 0;
  for (std::string raw; std::getline(stream, raw);) {
    ++number;
    std::string text = trimmed(raw.substr(0, raw.find('#')));
    const bool goes_on = !text.empty() && text.back() == '\\';
    if (goes_on) text.pop_back();
    if (continues)
      lines.back().text += text;
    else
      lines.push_back({text, number, raw.find(given_mark) != std::string::npos});
    continues = goes_on;
  }
  if (continues) refuse(file, number, "the last line ends in '\\', but there is no next line");
  return lines;
}

/// First word of a line and what follows it.
std::pair<std::string, std::string> split_word(const std::string& line) {
  const std::size_t end = line.find_first_of(" \t");
  if (end == std::string::npos) return {line, ""};
  return {line.substr(0, end), trimmed(line.substr(end))};
}

class Scanner {
 public:
  explicit Scanner(std::string file) { text_.file = std::move(file); }

  ParameterText scan(const std::string& content) {
    const bool is_listing = content.rfind(listing_title, 0) == 0;
    for (const Line& line : logical_lines(content, text_.file)) {
      const auto [word, rest] = split_word(trimmed(line.text));
      if (word == "set")
        add_assignment(rest, line.number, is_listing && !line.has_mark);
      else if (word == "subsection")
        open_section(rest, line.number);
      else if (word == "end" && rest.empty())
        close_section(line.number);
      else if (word == "include")
        refuse(text_.file, line.number, "'include' is not allowed in a case file");
      else if (!word.empty())
        refuse(text_.file, line.number,
               base::in_quotes(trimmed(line.text)) +
                   ": a line is 'set NAME = VALUE', 'subsection NAME', 'end', or a comment "
                   "after '#'");
    }
    if (!open_lines_.empty())
      refuse(
          text_.file, open_lines_.back(),
          fmt::format("the subsection {} is not closed by 'end'", base::in_quotes(path_.back())));
    return std::move(text_);
  }

 private:
  void add_assignment(const std::string& rest, int line, bool is_filled_in) {
    const std::size_t sign = rest.find('=');
    const std::string name = trimmed(rest.substr(0, sign));
    if (sign == std::string::npos || name.empty())
      refuse(text_.file, line,
             fmt::format("{}: 'set NAME = VALUE' is wanted", base::in_quotes("set " + rest)));
    const auto [first, is_new] = set_in_line_.emplace(std::make_pair(path_, name), line);
    if (!is_new)
      refuse(
          text_.file, line,
          fmt::format("{} has already been set in line {}", base::in_quotes(name), first->second));
    text_.assignments.push_back({path_, name, trimmed(rest.substr(sign + 1)), line, is_filled_in});
  }

  void open_section(const std::string& name, int line) {
    if (name.empty()) refuse(text_.file, line, "the subsection has no name");
    if (path_.size() == deepest_section)
      refuse(text_.file, line,
             fmt::format("there is no subsection {} in {}: is an 'end' missing?",
                         base::in_quotes(name), base::in_quotes(path_.back())));
    path_.push_back(name);
    open_lines_.push_back(line);
    text_.sections.push_back({path_, line});
  }

  void close_section(int line) {
    if (path_.empty()) refuse(text_.file, line, "'end' without a 'subsection' before it");
    path_.pop_back();
    open_lines_.pop_back();
  }

  ParameterText text_;
  SectionPath path_;
  std::vector<int> open_lines_;
  std::map<std::pair<SectionPath, std::string>, int> set_in_line_;
};

}  // namespace

const Assignment* ParameterText::find(const SectionPath& section, const std::string& name) const {
  for (const Assignment& assignment : assignments)
    if (assignment.section == section && assignment.name == name) return &assignment;
  return nullptr;
}

ParameterText read_parameter_text(const std::filesystem::path& file) {
  std::string content = read_content(file);
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  if (content.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
    content.erase(0, byte_order_mark.size());
  return parameter_text(file.string(), content);
}

ParameterText parameter_text(const std::string& file, const std::string& content) {
  check_characters(content, file);
  return Scanner(file).scan(content);
}

}  // namespace geneva::model
