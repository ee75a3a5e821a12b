#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::model {

/// Names of a subsection and those it stands in, outermost first; empty: top level.
using SectionPath = std::vector<std::string>;

/// A line "set name = value".
struct Assignment {
  SectionPath section;
  std::string name;
  std::string value;          ///< trimmed; the lines of a continued one joined
  int line;                   ///< its first, from 1; 0: varied
  bool is_filled_in = false;  ///< by a listing of all parameters, which had its default there
};

/// A line "subsection name".
struct OpenedSection {
  SectionPath path;
  int line;
};

/// A parameter file as it is written, before anything is known about the names in it.
struct ParameterText {
  std::string file;  ///< for messages
  std::vector<Assignment> assignments;
  std::vector<OpenedSection> sections;
  /// What sets the varied ones, for messages; empty: they are all that there is.
  std::string varied_by = "--set";

  /// The assignment of that name; nothing if there is none.
  [[nodiscard]] const Assignment* find(const SectionPath& section, const std::string& name) const;
};

/// Reads a file of "set", "subsection" and "end" lines, with '#' before comments and '\' at the end
/// of a line that goes on in the next one. An "include" is refused, since a case may come from
/// anyone.
/// @throws base::InputError with file and line, if there is no such file, it is larger than 1
/// MB, not UTF-8 text, a line cannot be understood, subsections are not closed, or a name is set
/// twice
ParameterText read_parameter_text(const std::filesystem::path& file);

/// The same of a text.
/// @param file what messages call it
ParameterText parameter_text(const std::string& file, const std::string& content);

}  // namespace geneva::model
