#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/units.h"

namespace geneva::base {

/// {"value": ..., "unit": ...}; null, since JSON knows no infinity, if the value is not finite.
nlohmann::json quantity(double value, const char* unit);

/// The same in the SI unit of the dimension.
nlohmann::json quantity(double value, Dimension dimension);

/// The number, or null if it is not finite.
nlohmann::json finite(double value);

/// What a document is about.
struct CaseHeader {
  std::string name;
  std::string title;
  std::string date;  ///< local date and time at which the document was made, ISO 8601
  UnitSystem units;  ///< of the other files
  std::string
      content;  ///< mark of what the case is about; documents with equal ones belong together
  std::string project = {};
  std::string author = {};
  std::string inputs = {};  ///< the case file with every default filled in
  /// Values with their units that it leaves to a rule, by parameter with its subsections but the
  /// model's: "Pin/Root gap".
  std::map<std::string, std::string> worked_out = {};
};

/// Section "case" of a document.
nlohmann::json case_section(const CaseHeader& header);

/// Of the files that the program writes; grows whenever a reader of the files must know.
constexpr int results_format = 5;

/// Section "versions" of a document: the program's and results_format.
nlohmann::json versions_section(const std::string& geneva_version);

}  // namespace geneva::base
