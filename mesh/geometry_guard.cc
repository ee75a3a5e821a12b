#include "mesh/geometry_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "mesh/geometry_words.h"

namespace geneva::mesh {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;
constexpr std::size_t deepest_include = 8;
constexpr std::size_t largest_geometry = std::size_t{8} << 20;
constexpr std::size_t most_tokens = 500000;
constexpr std::size_t most_files = 1000;
constexpr std::size_t longest_line = 2000;
constexpr int most_conversions = 8;

const char* const what_is_allowed =
    "a geometry may only draw and mesh: points, curves, loops, surfaces, physical groups, "
    "transformations, mesh sizes, transfinite and recombination commands, fields, loops, "
    "conditions, macros, variables, Mesh.* and Geometry.* options, Printf to the terminal, and "
    "Include or Merge of a .geo or .msh file inside the directory of the geometry";

using Words = std::set<std::string_view>;

bool contains(const Words& words, std::string_view word) { return words.count(word) != 0; }

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

[[noreturn]] void refuse(const Token& token, const std::string& why) {
  throw error_at(token.line,
                 fmt::format("'{}' is refused: {}; {}", token.text, why, what_is_allowed));
}

/// Tokens of one file with what the checks need to know about their surroundings.
class Checker {
 public:
  explicit Checker(const std::vector<Token>& tokens)
      : tokens_(tokens), match_(matching_brackets(tokens)), variables_(assigned_names()) {}

  void run() const {
    check_blocks();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      switch (tokens_[i].kind) {
        case TokenKind::word:
          check_word(i);
          break;
        case TokenKind::text:
          check_text_place(i);
          break;
        case TokenKind::symbol:
          check_symbol(i);
          break;
        case TokenKind::number:
        case TokenKind::merge:
          break;
      }
    }
  }

 private:
  /// Text of a token; empty beyond the ends.
  [[nodiscard]] std::string_view at(std::size_t index) const {
    return index < tokens_.size() ? std::string_view(tokens_[index].text) : std::string_view();
  }
  [[nodiscard]] std::string_view before(std::size_t index) const {
    return index == 0 ? std::string_view() : at(index - 1);
  }
  [[nodiscard]] bool is(std::size_t index, TokenKind kind) const {
    return index < tokens_.size() && tokens_[index].kind == kind;
  }
  [[nodiscard]] static bool assigns(std::string_view symbol) {
    return one_of(symbol, {"=", "+=", "-=", "*=", "/="});
  }

  /// Index after a name with its suffixes ~{...}, [...] and (...).
  [[nodiscard]] std::size_t after_name(std::size_t index) const {
    std::size_t next = index + 1;
    if (at(next) == "~" && at(next + 1) == "{") next = match_[next + 1] + 1;
    if (at(next) == "[" || at(next) == "(") next = match_[next] + 1;
    return next;
  }

  [[nodiscard]] Words assigned_names() const {
    Words names;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!is(i, TokenKind::word) || is_command(at(i)) || is_context_word(at(i))) continue;
      const bool is_member = before(i) == ".";
      const bool is_macro = before(i) == "Macro" || before(i) == "Function";
      const bool is_counter = before(i) == "For" && at(i + 1) == "In";
      if (!is_member && (is_macro || is_counter || assigns(at(after_name(i))))) names.insert(at(i));
    }
    return names;
  }

  void check_word(std::size_t index) const {
    const Token& token = tokens_[index];
    if (const char* const harm = harm_of(token.text); harm != nullptr) refuse(token, harm);
    if (before(index) == ".") return check_member(index);
    if (token.text == "Mesh" || token.text == "Geometry") return check_options(index);
    if (is_command(token.text)) return check_command(index);
    if (is_context_word(token.text)) return;
    if (token.text == "Include" || token.text == "Merge")
      refuse(token, "it must be a statement of its own with a written-out file name: " +
                        token.text + " \"name.geo\";");
    if (!contains(variables_, token.text))
      refuse(token,
             "it is neither a command of drawing and meshing nor a variable that is "
             "assigned in the file");
    check_variable(index);
  }

  /// A variable's value may be used; a variable in front of something else is a command of Gmsh.
  void check_variable(std::size_t index) const {
    if (one_of(before(index), {"Macro", "Function", "Call"})) return;
    const std::size_t next = index + 1;
    const bool runs_on = is(next, TokenKind::number) || is(next, TokenKind::text) ||
                         one_of(at(next), {".", "{", "::"}) ||
                         (is(next, TokenKind::word) && !is_command(at(next)));
    if (runs_on) refuse(tokens_[index], fmt::format("a variable may not precede {}", at(next)));
  }

  void check_options(std::size_t index) const {
    const bool is_option = at(index + 1) == ".";
    const bool is_mesh_now =
        at(index) == "Mesh" && one_of(at(index + 1), {"1", "2", "3"}) && at(index + 2) == ";";
    const bool is_all = at(index) == "Mesh" && before(index) == "Coherence";
    if (!is_option && !is_mesh_now && !is_all)
      refuse(tokens_[index], "it must be an option (Mesh.Name) or 'Mesh 2;' or 'Mesh 3;'");
  }

  void check_member(std::size_t index) const {
    if (at(index).rfind("DoubleClicked", 0) == 0) refuse(tokens_[index], "it sets a command");
    if (at(index) != "Algorithm") return;
    // 8 (for quadrilaterals) crashes in Gmsh 4.8, 3, 4, 7 and 9 are not for plane quadrilaterals
    const bool is_known =
        at(index + 1) == "=" && one_of(at(index + 2), {"1", "2", "5", "6"}) && at(index + 3) == ";";
    if (!is_known) refuse(tokens_[index], "Mesh.Algorithm may be 1, 2, 5 or 6");
  }

  void check_command(std::size_t index) const {
    const std::string_view word = at(index);
    if (word == "SetFactory" && at(index + 2) != "\"OpenCASCADE\"" &&
        at(index + 2) != "\"Built-in\"")
      refuse(tokens_[index], "the kernels are \"Built-in\" and \"OpenCASCADE\"");
    const bool names_a_macro = one_of(word, {"Macro", "Function", "Call"});
    if (names_a_macro && (!is(index + 1, TokenKind::word) || is_command(at(index + 1))))
      refuse(tokens_[index], "the macro's name must be a plain word");
    if (word == "Sprintf") return check_format(index);
    if (!one_of(word, {"Printf", "Warning", "Error"})) return;
    check_format(index);
    const std::string_view after = at(match_[index + 1] + 1);
    if (after == ">" || after == ">>") refuse(tokens_[index], "here it writes to a file");
    if (after != ";") refuse(tokens_[index], "it must end after its closing bracket");
  }

  /// Gmsh hands formats to C's sprintf with buffers of fixed length: only short numbers may come
  /// in.
  void check_format(std::size_t index) const {
    if ((at(index + 1) != "(" && at(index + 1) != "[") || !is(index + 2, TokenKind::text))
      refuse(tokens_[index], "its first argument must be a text in quotation marks");
    const std::string_view format = at(index + 2);
    int conversions = 0;
    for (std::size_t i = format.find('%'); i != format.npos; i = format.find('%', i)) {
      ++conversions;
      const std::size_t length = conversion_length(format.substr(i + 1));
      if (length == 0 || conversions > most_conversions)
        refuse(tokens_[index],
               fmt::format("a format may hold at most {} conversions, of the kind %g, %12.6f or %%",
                           most_conversions));
      i += 1 + length;
    }
    if (conversions == 0 && at(index + 3) == ",")
      refuse(tokens_[index], "its format must say how the numbers are written, such as %g");
  }

  /// Characters of a conversion after its percent sign; 0: not one of a number.
  [[nodiscard]] static std::size_t conversion_length(std::string_view format) {
    if (!format.empty() && format.front() == '%') return 1;
    const auto digits = [&](std::size_t from) {
      std::size_t to = from;
      while (to < format.size() && format[to] >= '0' && format[to] <= '9') ++to;
      return to;
    };
    std::size_t at = !format.empty() && one_of(format.substr(0, 1), {"-", "+", "0"}) ? 1 : 0;
    const std::size_t width = digits(at);
    std::size_t precision = width;
    if (width < format.size() && format[width] == '.') precision = digits(width + 1);
    if (width - at > 2 || precision - width > 3 || precision == format.size()) return 0;
    return one_of(format.substr(precision, 1), {"e", "E", "f", "F", "g", "G"}) ? precision + 1 : 0;
  }

  /// A text after a name would be a command with an argument, one after > a file to write to.
  void check_text_place(std::size_t index) const {
    static const Words before_a_text{"(",    "[",     "{",    ",",     "=",       "Show",
                                     "Hide", "Point", "Line", "Curve", "Surface", "Volume",
                                     "Name", "Label", "Help", "Units"};
    const bool is_argument = index > 0 && tokens_[index - 1].kind != TokenKind::text &&
                             contains(before_a_text, at(index - 1));
    if (!is_argument) refuse(tokens_[index], "a text may not stand here");
  }

  void check_symbol(std::size_t index) const {
    const std::string_view symbol = at(index);
    if (one_of(symbol, {">>", "<<", "::", "&", "|"}))
      refuse(tokens_[index], "the operator belongs in no geometry");
    if (symbol != ".") return;
    if (index == 0 || !is(index + 1, TokenKind::word))
      refuse(tokens_[index], "a name must stand on both sides");
    const bool is_field = at(index - 1) == "]" && before(match_[index - 1]) == "Field";
    const bool is_colour = at(index - 1) == "Color" && before(index - 1) == ".";
    const bool is_option = at(index - 1) == "Mesh" || at(index - 1) == "Geometry";
    if (!is_field && !is_option && !is_colour)
      refuse(tokens_[index], fmt::format("'{}.{}' is not an option of Mesh, Geometry or a field",
                                         at(index - 1), at(index + 1)));
  }

  /// Gmsh counts open blocks beyond the end of a file and reads on in the wrong place.
  void check_blocks() const {
    static const std::map<std::string_view, std::string_view> ends{
        {"If", "EndIf"}, {"For", "EndFor"}, {"Macro", "Return"}, {"Function", "Return"}};
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!is(i, TokenKind::word) || before(i) == ".") continue;
      if (ends.count(at(i)) != 0) open.push_back(i);
      const bool is_branch = at(i) == "Else" || at(i) == "ElseIf";
      if (is_branch && (open.empty() || at(open.back()) != "If"))
        refuse(tokens_[i], "it belongs to no If");
      if (at(i) != "EndIf" && at(i) != "EndFor" && at(i) != "Return") continue;
      if (open.empty() || ends.at(at(open.back())) != at(i))
        refuse(tokens_[i], "it ends no block of its kind");
      open.pop_back();
    }
    if (!open.empty())
      refuse(tokens_[open.back()], fmt::format("{} is missing", ends.at(at(open.back()))));
  }

  const std::vector<Token>& tokens_;
  std::vector<std::size_t> match_;
  Words variables_;
};

/// Reads a file and puts the tokens of included ones in the place of their Include.
class Collector {
 public:
  explicit Collector(const std::filesystem::path& file)
      : directory_(std::filesystem::canonical(file).parent_path()) {
    collect(file, std::filesystem::canonical(file), 0);
  }

  std::vector<Token> tokens;
  std::vector<std::filesystem::path> meshes;

 private:
  void collect(const std::filesystem::path& shown, const std::filesystem::path& file,
               std::size_t depth) {
    const std::string content = read_file(file);
    if (content.size() > largest_geometry || ++files_ > most_files) refuse_size(shown);
    const std::vector<Token> own = tokenize(content, shown);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (!is_file_command(own, i)) {
        tokens.push_back(own[i]);
      } else {
        add_file(own[i], own[i + 1], file, depth);
        i += 2;
      }
    }
    if (tokens.size() > most_tokens) refuse_size(shown);
  }

  [[noreturn]] static void refuse_size(const std::filesystem::path& file) {
    throw std::invalid_argument(
        fmt::format("{}: the geometry with all that it includes has more than {} MiB, {} words or "
                    "{} files: mesh it with Gmsh and give the .msh file",
                    file.string(), largest_geometry >> 20, most_tokens, most_files));
  }

  static bool is_file_command(const std::vector<Token>& own, std::size_t index) {
    if (own[index].kind != TokenKind::word) return false;
    if (own[index].text != "Include" && own[index].text != "Merge") return false;
    const bool begins = index == 0 || one_of(own[index - 1].text,
                                             {";", "}", ")", "Else", "EndIf", "EndFor", "Return"});
    return begins && index + 2 < own.size() && own[index + 1].kind == TokenKind::text &&
           own[index + 2].text == ";";
  }

  void add_file(const Token& command, const Token& name, const std::filesystem::path& from,
                std::size_t depth) {
    const std::filesystem::path given(name.text.substr(1, name.text.size() - 2));
    const std::filesystem::path target =
        std::filesystem::weakly_canonical(from.parent_path() / given);
    const std::filesystem::path inside = target.lexically_relative(directory_);
    if (given.is_absolute() || inside.empty() || *inside.begin() == "..")
      refuse(command, fmt::format("{} lies outside of {}", name.text, directory_.string()));
    if (!std::filesystem::is_regular_file(target))
      refuse(command, fmt::format("{} is not a file that exists", target.string()));
    if (depth >= deepest_include)
      refuse(command, fmt::format("files include each other more than {} deep", deepest_include));
    if (target.extension() == ".geo") return collect(target, target, depth + 1);
    if (target.extension() != ".msh" || command.text != "Merge")
      refuse(command, fmt::format("{} is no .geo file, nor a .msh file to merge", name.text));
    tokens.push_back(
        {TokenKind::merge, fmt::format("Merge \"{}\";", merged_name(meshes.size())), command.line});
    meshes.push_back(target);
  }

  std::filesystem::path directory_;
  std::size_t files_ = 0;
};

/// Spells the tokens with blanks between them, on lines like those of their files.
GuardedGeometry spelt(const std::vector<Token>& tokens) {
  GuardedGeometry geometry;
  std::size_t length = 0;
  for (const Token& token : tokens) {
    const bool goes_on = !geometry.lines.empty() && length < longest_line &&
                         geometry.lines.back().number == token.line.number &&
                         geometry.lines.back().file == token.line.file;
    if (goes_on) {
      geometry.text += ' ';
    } else {
      if (!geometry.lines.empty()) geometry.text += '\n';
      geometry.lines.push_back(token.line);
      length = 0;
    }
    geometry.text += token.text;
    length += token.text.size() + 1;
  }
  geometry.text += '\n';
  return geometry;
}

}  // namespace

std::string merged_name(std::size_t index) { return fmt::format("merged-{}.msh", index); }

std::string read_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw std::invalid_argument(fmt::format("{}: there is no such file", file.string()));
  if (!std::filesystem::is_regular_file(file))
    throw std::invalid_argument(fmt::format("{}: this is not a file", file.string()));
  if (std::filesystem::file_size(file) > largest_file)
    throw std::invalid_argument(
        fmt::format("{}: the file is larger than {} MiB: a coarse mesh is all that is needed, it "
                    "is refined while solving",
                    file.string(), largest_file >> 20));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream)
    throw std::invalid_argument(fmt::format("{}: the file cannot be read", file.string()));
  return content.str();
}

GuardedGeometry guard_geometry(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw std::invalid_argument(fmt::format("{}: there is no such file", file.string()));
  const Collector collected(file);
  Checker(collected.tokens).run();
  GuardedGeometry geometry = spelt(collected.tokens);
  geometry.meshes = collected.meshes;
  return geometry;
}

}  // namespace geneva::mesh
