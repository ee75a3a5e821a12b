#include "app/highlight.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

namespace geneva::app {

namespace {

constexpr const char* yellow = "\033[33m";
constexpr const char* red = "\033[31m";
constexpr const char* plain = "\033[0m";

bool begins_with(const std::string& line, const char* const beginning) {
  return line.rfind(beginning, 0) == 0;
}

/// Whether the user can and wants to see colours there (no-color.org).
bool takes_colours(std::FILE* const stream) {
  const char* const refused = std::getenv("NO_COLOR");
  return is_terminal(stream) && (refused == nullptr || *refused == '\0');
}

std::string in_colour(const std::string& line) {
  constexpr std::array<const char*, 3> bad{"EXCEEDED", "cannot be kept", "not converged"};
  const bool is_bad = begins_with(line, "geneva: ") ||
                      std::any_of(bad.begin(), bad.end(), [&](const char* const words) {
                        return line.find(words) != std::string::npos;
                      });
  const bool is_note = begins_with(line, "note: ");
  if (!is_bad && !is_note) return line;
  return (is_bad ? red : yellow) + line + plain;
}

}  // namespace

bool is_terminal(std::FILE* const stream) {
  const char* const terminal = std::getenv("TERM");
  const bool is_started_by_mpirun = std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
  return isatty(fileno(stream)) == 1 && !is_started_by_mpirun && terminal != nullptr &&
         std::string(terminal) != "dumb";
}

std::string highlighted(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += in_colour(line) + "\n";
  if (!text.empty() && text.back() != '\n') result.pop_back();
  return result;
}

std::string for_stream(const std::string& text, std::FILE* const stream) {
  return takes_colours(stream) ? highlighted(text) : text;
}

}  // namespace geneva::app
