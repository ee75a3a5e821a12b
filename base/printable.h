#pragma once

#include <string>

namespace geneva::base {

/// A text of a program that is not trusted, for a terminal: without control characters, and cut
/// after 1000 bytes.
inline std::string printable(std::string text) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return text;
}

}  // namespace geneva::base
