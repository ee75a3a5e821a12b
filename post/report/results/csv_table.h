#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::post {

/// One column of a table of results.
struct CsvColumn {
  std::string name;
  std::string unit;                ///< empty: none
  std::vector<double> values;      ///< not a number where the field is empty or a word
  std::vector<std::string> words;  ///< the fields as they stand
};

/// A table as this program writes it: a heading "name [unit]" for each column, then rows.
struct CsvTable {
  std::vector<CsvColumn> columns;

  [[nodiscard]] std::size_t n_rows() const {
    return columns.empty() ? 0 : columns.front().words.size();
  }
  /// @throws base::InputError if there is no such column
  [[nodiscard]] const CsvColumn& column(const std::string& name) const;
  [[nodiscard]] bool has_column(const std::string& name) const;
  /// The rows whose field in a column is a word.
  [[nodiscard]] CsvTable rows_with(const std::string& column, const std::string& word) const;
};

/// @throws base::InputError if the file cannot be read or a row has another number of fields
/// than the heading, with the row
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace geneva::post
