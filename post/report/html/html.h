#pragma once

#include <string>
#include <vector>

namespace geneva::post {

/// The text with everything escaped that HTML would take for markup, in elements and attributes.
std::string escaped(const std::string& text);

/// A table with headings for its columns and rows; the cells are HTML.
struct HtmlTable {
  std::string caption;                ///< HTML
  std::vector<std::string> headings;  ///< escaped text; the first is that of the rows' headings
  std::vector<std::vector<std::string>> rows;  ///< HTML; the first cell is the row's heading
  std::string kind = "";                       ///< class of the table; empty: none

  [[nodiscard]] std::string html() const;
};

/// A section of the report, with an anchor.
std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& content);

}  // namespace geneva::post
