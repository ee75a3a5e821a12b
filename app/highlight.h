#pragma once

#include <cstdio>
#include <string>

namespace geneva::app {

/// Whether a stream is a terminal that understands control sequences. Open MPI gives its processes
/// one even where its own output is a file: then it is none.
bool is_terminal(std::FILE* stream);

/// Lines with their meaning in colour: notes in yellow; errors and limits that are exceeded in red.
std::string highlighted(const std::string& text);

/// The text as a stream takes it: highlighted if that is a terminal that knows colours and the user
/// has not set NO_COLOR, else as it is.
std::string for_stream(const std::string& text, std::FILE* stream);

}  // namespace geneva::app
