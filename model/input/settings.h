#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "model/input/case_file.h"
#include "model/input/parameter_text.h"

namespace geneva::model {

/// A parameter that a program sets: a text as a case file would say it, or numbers in the case's
/// output unit of the parameter's dimension.
struct Setting {
  SectionPath section;
  std::string name;
  std::variant<std::string, std::vector<double>> value;
};

/// The value as a case file would say it.
/// @param text of the case, whose model and output units count
/// @throws base::InputError as parameters_of()
std::string text_of(const Setting& setting, const ParameterText& text,
                    const std::filesystem::path& directory);

/// The case of a text in which parameters are set, each in place of what the text says of it.
/// @param directory where the files lie that the case names, and after which it is called
/// @throws base::InputError as case_of(), for a parameter that is set twice, and for what no case
/// file can say: a value of several lines, or with '#'
Case case_with(ParameterText text, const std::vector<Setting>& settings,
               const std::filesystem::path& directory);

}  // namespace geneva::model
