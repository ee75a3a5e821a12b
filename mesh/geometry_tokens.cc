#include "mesh/geometry_tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

namespace geneva::mesh {

namespace {

// Gmsh 4.8 formats its messages in buffers of 1024 characters without looking at the length.
constexpr std::size_t longest_word = 200;
constexpr std::size_t longest_number = 60;
constexpr std::size_t longest_text = 250;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

/// When a condition is false, Gmsh looks for the end of the branch letter by letter, also inside of
/// texts and names, and reads on from there: a text could hide a command behind such a word.
bool ends_a_branch(std::string_view text) {
  for (const std::string_view word : {"Else", "ElseIf", "EndIf", "EndFor", "Return"})
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      if (end == text.size() || !is_letter(text[end])) return true;
    }
  return false;
}

class Tokenizer {
 public:
  Tokenizer(const std::string& content, const std::filesystem::path& file)
      : content_(content), file_(file) {}

  std::vector<Token> run() {
    refuse_encoding();
    skip_blanks_and_comments();
    while (at_ < content_.size()) {
      tokens_.push_back(next());
      skip_blanks_and_comments();
    }
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < content_.size() ? content_[at_ + ahead] : '\0';
  }
  [[nodiscard]] SourceLine here() const { return {file_, line_}; }

  void advance(std::size_t characters) {
    const auto begin = content_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = begin + static_cast<std::ptrdiff_t>(characters);
    line_ += static_cast<int>(std::count(begin, end, '\n'));
    at_ += characters;
  }

  void refuse_encoding() const {
    if (content_.rfind("\xEF\xBB\xBF", 0) == 0)
      throw error_at(here(), "the file begins with a byte order mark: save it as plain UTF-8");
    const std::size_t zero = content_.find('\0');
    if (zero == content_.npos) return;
    const auto end = content_.begin() + static_cast<std::ptrdiff_t>(zero);
    const auto line = 1 + static_cast<int>(std::count(content_.begin(), end, '\n'));
    throw error_at({file_, line}, "the file holds a zero byte: it is no text; save it as UTF-8");
  }

  void skip_blanks_and_comments() {
    while (at_ < content_.size()) {
      if (is_blank(peek())) {
        advance(1);
      } else if (peek() == '/' && peek(1) == '/') {
        advance(std::min(content_.find('\n', at_), content_.size()) - at_);
      } else if (peek() == '/' && peek(1) == '*') {
        const std::size_t end = content_.find("*/", at_ + 2);
        if (end == content_.npos) throw error_at(here(), "the comment has no end: add */");
        advance(end + 2 - at_);
      } else {
        return;
      }
    }
  }

  Token next() {
    const char first = peek();
    if (is_letter(first)) return word();
    if (is_digit(first) || (first == '.' && is_digit(peek(1)))) return number();
    if (first == '"' || first == '\'') return text();
    return symbol();
  }

  Token take(TokenKind kind, std::size_t length, std::size_t longest) {
    const std::string taken = content_.substr(at_, length);
    if (length > longest)
      throw error_at(here(), fmt::format("'{}...' has {} characters: at most {} are allowed",
                                         taken.substr(0, 40), length, longest));
    Token token{kind, taken, here()};
    advance(length);
    return token;
  }

  Token word() {
    std::size_t length = 1;
    while (is_letter(peek(length)) || is_digit(peek(length))) ++length;
    Token token = take(TokenKind::word, length, longest_word);
    const std::array<std::string_view, 5> commands{"Else", "ElseIf", "EndIf", "EndFor", "Return"};
    const bool is_command =
        std::find(commands.begin(), commands.end(), token.text) != commands.end();
    if (!is_command && ends_a_branch(token.text))
      throw error_at(token.line,
                     fmt::format("the name '{}' holds a word that Gmsh mistakes for the "
                                 "end of a branch: choose another name",
                                 token.text));
    return token;
  }

  Token number() {
    std::size_t length = digits(0);
    if (peek(length) == '.') length = digits(length + 1);
    if (peek(length) == 'e' || peek(length) == 'E') {
      const std::size_t sign = peek(length + 1) == '+' || peek(length + 1) == '-' ? 1 : 0;
      if (is_digit(peek(length + 1 + sign))) length = digits(length + 1 + sign);
    }
    return take(TokenKind::number, length, longest_number);
  }

  [[nodiscard]] std::size_t digits(std::size_t from) const {
    while (is_digit(peek(from))) ++from;
    return from;
  }

  Token text() {
    const std::size_t end = content_.find_first_of(std::string{peek(), '\n'}, at_ + 1);
    if (end == content_.npos || content_[end] == '\n')
      throw error_at(here(), "the text has no closing quotation mark on its line");
    Token token = take(TokenKind::text, end + 1 - at_, longest_text);
    const std::string_view inside(token.text.data() + 1, token.text.size() - 2);
    const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
    if (std::any_of(inside.begin(), inside.end(), is_control) ||
        inside.find_first_of("\"\\") != inside.npos)
      throw error_at(token.line, "a text may not hold control characters, \" or \\");
    if (ends_a_branch(inside))
      throw error_at(token.line,
                     fmt::format("the text {} holds one of the words Else, ElseIf, EndIf, EndFor "
                                 "and Return, which Gmsh mistakes for a command: say it otherwise",
                                 token.text));
    return token;
  }

  Token symbol() {
    for (const std::string_view known : {"...", "+=", "-=", "*=", "/=", "::", "||", "&&", "++",
                                         "--", "==", "!=", "<=", ">=", ">>", "<<"})
      if (content_.compare(at_, known.size(), known) == 0)
        return take(TokenKind::symbol, known.size(), known.size());
    const std::string_view single = ";=:,.()[]{}<>+-*/^%!?~#&|";
    if (single.find(peek()) == single.npos)
      throw error_at(here(), fmt::format("the character '{}' (code {}) belongs in no geometry",
                                         peek() >= ' ' && peek() < '\x7f' ? peek() : '?',
                                         static_cast<int>(static_cast<unsigned char>(peek()))));
    return take(TokenKind::symbol, 1, 1);
  }

  const std::string& content_;
  std::filesystem::path file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::invalid_argument error_at(const SourceLine& line, const std::string& what) {
  return std::invalid_argument(fmt::format("{}:{}: {}", line.file.string(), line.number, what));
}

std::vector<Token> tokenize(const std::string& content, const std::filesystem::path& file) {
  return Tokenizer(content, file).run();
}

std::vector<std::size_t> matching_brackets(const std::vector<Token>& tokens) {
  const std::string_view opening = "([{";
  const std::string_view closing = ")]}";
  std::vector<std::size_t> match(tokens.size());
  std::iota(match.begin(), match.end(), std::size_t{0});
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::symbol || tokens[i].text.size() != 1) continue;
    const char c = tokens[i].text.front();
    if (opening.find(c) != opening.npos) open.push_back(i);
    const std::size_t kind = closing.find(c);
    if (kind == closing.npos) continue;
    if (open.empty() || tokens[open.back()].text.front() != opening[kind])
      throw error_at(tokens[i].line, fmt::format("'{}' closes no bracket of its kind", c));
    match[open.back()] = i;
    match[i] = open.back();
    open.pop_back();
  }
  if (!open.empty())
    throw error_at(tokens[open.back()].line,
                   fmt::format("'{}' is never closed", tokens[open.back()].text));
  return match;
}

}  // namespace geneva::mesh
