#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/input/parameter_text.h"
#include "model/input/parameters.h"

namespace geneva::model {

/// Throws a message about a place of a file: file, line, reason.
/// @param line 0: of what has been set beside the file
[[noreturn]] void refuse(const ParameterText& text, int line, const std::string& reason);

/// Throws the message about a parameter of a file: file, line, name, value found, reason.
[[noreturn]] void refuse(const ParameterText& text, const Assignment& found,
                         const std::string& reason);

/// The parameters of a case: what its file says, checked, and the defaults of the rest.
class CaseValues {
 public:
  /// @throws base::InputError for names that are not among the parameters (with the nearest
  /// that is), values that their rule does not allow, and missing required ones
  CaseValues(const std::vector<Parameter>& parameters, const ParameterText& text);

  [[nodiscard]] const std::string& text(const SectionPath& section, const std::string& name) const;
  /// Value in SI units; nothing if a word stands in its place or it was left out.
  [[nodiscard]] std::optional<double> value(const SectionPath& section,
                                            const std::string& name) const;
  /// Values in SI units; none if they were left out.
  [[nodiscard]] std::vector<double> values(const SectionPath& section,
                                           const std::string& name) const;

  /// Parameters of a subsection whose names begin so.
  [[nodiscard]] std::vector<std::string> names(const SectionPath& section,
                                               const std::string& begin) const;

  /// Whether the parameter has another value than its default.
  [[nodiscard]] bool is_changed(const SectionPath& section, const std::string& name) const;

  /// Throws the message about a parameter: file, line, name, value, reason.
  [[noreturn]] void refuse(const SectionPath& section, const std::string& name,
                           const std::string& reason) const;
  /// Throws the message that a parameter is missing, and why it is wanted.
  [[noreturn]] void refuse_missing(const SectionPath& section, const std::string& name,
                                   const std::string& reason) const;
  /// Throws a message about a whole subsection.
  [[noreturn]] void refuse_section(const SectionPath& section, const std::string& reason) const;

  /// The parameter file with every default filled in.
  [[nodiscard]] std::string completed() const;

 private:
  [[nodiscard]] const Parameter& parameter(const SectionPath& section,
                                           const std::string& name) const;

  std::vector<Parameter> parameters_;
  ParameterText text_;
  std::map<std::pair<SectionPath, std::string>, std::string> values_;  ///< by section and name
};

/// One subsection of the values.
class CaseSection {
 public:
  CaseSection(const CaseValues& values, SectionPath path);

  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] bool is_given(const std::string& name) const;
  /// Whether the parameter has another value than its default.
  [[nodiscard]] bool is_changed(const std::string& name) const;
  /// @throws base::InputError if the parameter is left out or a word stands in its place
  [[nodiscard]] double value(const std::string& name) const;
  [[nodiscard]] std::optional<double> optional_value(const std::string& name) const;
  [[nodiscard]] std::vector<double> values(const std::string& name) const;
  [[noreturn]] void refuse(const std::string& name, const std::string& reason) const;
  [[noreturn]] void refuse_missing(const std::string& name, const std::string& reason) const;
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  const CaseValues* values_;
  SectionPath path_;
};

}  // namespace geneva::model
