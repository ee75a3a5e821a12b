#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace geneva::mesh {

/// A line of a geometry file.
struct SourceLine {
  std::filesystem::path file;
  int number;  ///< from 1
};

/// An error at a line of a geometry file: "file:line: what".
std::invalid_argument error_at(const SourceLine& line, const std::string& what);

enum class TokenKind {
  word,    ///< a command, a keyword or the name of a variable
  number,  ///< without sign
  text,    ///< including its quotation marks
  symbol,  ///< an operator, a bracket, a comma, a semicolon
  merge    ///< a whole statement that merges a mesh which has been checked
};

struct Token {
  TokenKind kind;
  std::string text;
  SourceLine line;
};

/// Splits a .geo file into its tokens, as Gmsh does; comments are left out.
///
/// A text (in quotation marks) stays on one line and holds no word at which Gmsh, when it skips the
/// branch of an If, would take up reading inside of it.
/// @param content of the file
/// @param file for messages
/// @throws std::invalid_argument naming file and line: characters that belong in no geometry, a
/// comment or text without end, words, numbers and texts that are too long for Gmsh's buffers
std::vector<Token> tokenize(const std::string& content, const std::filesystem::path& file);

/// Index of the bracket that closes the one at `index`, for every bracket; other tokens: their own
/// index.
/// @throws std::invalid_argument if brackets do not match
std::vector<std::size_t> matching_brackets(const std::vector<Token>& tokens);

}  // namespace geneva::mesh
