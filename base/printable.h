#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace geneva::base {

/// A text that a stranger may have written, for a terminal: with spaces in the place of control
/// characters other than the ends of lines.
inline std::string without_controls(std::string text) {
  const auto byte = [&](const std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((byte(i) < ' ' && text[i] != '\n') || byte(i) == 0x7f) text[i] = ' ';
    // U+0080 to U+009F, in UTF-8
    const bool is_long = byte(i) == 0xc2 && i + 1 < text.size() && byte(i + 1) < 0xa0;
    if (is_long) text[i] = text[i + 1] = ' ';
  }
  return text;
}

/// The same of a program that is not trusted: in one line, and cut after 1000 bytes.
inline std::string printable(std::string text) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  std::replace(text.begin(), text.end(), '\n', ' ');
  return without_controls(text);
}

}  // namespace geneva::base
