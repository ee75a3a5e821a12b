#include "post/report/results/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/errors.h"

namespace geneva::post {

namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::stringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) result.push_back(field);
  return result;
}

double number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return word.empty() || *end != '\0' ? std::nan("") : value;
}

CsvColumn column_of(const std::string& heading) {
  const std::size_t bracket = heading.find(" [");
  if (bracket == std::string::npos) return {heading, "", {}, {}};
  return {heading.substr(0, bracket),
          heading.substr(bracket + 2, heading.size() - bracket - 3),
          {},
          {}};
}

}  // namespace

bool CsvTable::has_column(const std::string& name) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const CsvColumn& column) { return column.name == name; });
}

const CsvColumn& CsvTable::column(const std::string& name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const CsvColumn& column) { return column.name == name; });
  if (found == columns.end()) throw base::InputError(fmt::format("there is no column '{}'", name));
  return *found;
}

CsvTable CsvTable::rows_with(const std::string& name, const std::string& word) const {
  const CsvColumn& key = column(name);
  CsvTable result;
  for (const CsvColumn& from : columns) {
    CsvColumn to{from.name, from.unit, {}, {}};
    for (std::size_t row = 0; row < n_rows(); ++row)
      if (key.words[row] == word) {
        to.values.push_back(from.values[row]);
        to.words.push_back(from.words[row]);
      }
    result.columns.push_back(std::move(to));
  }
  return result;
}

CsvTable read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!stream || !std::getline(stream, line))
    throw base::InputError(file.string() + " cannot be read");
  CsvTable table;
  for (const std::string& heading : fields(line)) table.columns.push_back(column_of(heading));
  while (std::getline(stream, line)) {
    const std::vector<std::string> row = fields(line);
    if (row.size() != table.columns.size())
      throw base::InputError(
          fmt::format("{}, line {}: {} fields instead of {}: the file is damaged, make it again",
                      file.string(), table.n_rows() + 2, row.size(), table.columns.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      table.columns[i].words.push_back(row[i]);
      table.columns[i].values.push_back(number(row[i]));
    }
  }
  return table;
}

}  // namespace geneva::post
