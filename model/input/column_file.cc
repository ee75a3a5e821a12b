#include "model/input/column_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "base/errors.h"
#include "model/input/parameter_rule.h"

namespace geneva::model {

namespace {

/// Finite, in decimal notation.
std::optional<double> number(const std::string& text) {
  double value = 0.;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Reads line after line; the first one is the heading.
class ColumnReader {
 public:
  ColumnReader(const std::array<Column, 2>& columns, const std::string& example)
      : columns_(columns), example_(example) {}

  void read(const std::string& line) {
    const std::vector<std::string> parts = split_list(line);
    if (parts.size() != 2)
      throw base::InputError(
          fmt::format("{} is not two columns separated by a comma", base::in_quotes(line)));
    if (units_)
      read_row(line, parts);
    else
      units_ = {unit_of(parts[0], columns_[0]), unit_of(parts[1], columns_[1])};
  }

  [[nodiscard]] const std::array<std::vector<double>, 2>& values() const { return values_; }

 private:
  /// SI value of one unit of a column, from "name [unit]".
  [[nodiscard]] double unit_of(const std::string& heading, const Column& column) const {
    const std::size_t open = heading.find('[');
    if (trimmed(heading.substr(0, open)) != column.name || open == std::string::npos ||
        heading.back() != ']')
      throw base::InputError(fmt::format("the heading is {}: '{}' is wanted, with {}",
                                         base::in_quotes(heading), example_, any_units()));
    return base::parse_quantity("1 " + heading.substr(open + 1, heading.size() - open - 2),
                                column.dimension);
  }

  [[nodiscard]] std::string any_units() const {
    const std::string first = base::name_of(columns_[0].dimension);
    const std::string second = base::name_of(columns_[1].dimension);
    return first == second ? "any unit of " + first : "any units of " + first + " and " + second;
  }

  void read_row(const std::string& line, const std::vector<std::string>& parts) {
    const auto first = number(parts[0]);
    const auto second = number(parts[1]);
    if (!first || !second)
      throw base::InputError(
          fmt::format("{} is not two numbers separated by a comma", base::in_quotes(line)));
    values_[0].push_back(*first * (*units_)[0]);
    values_[1].push_back(*second * (*units_)[1]);
  }

  const std::array<Column, 2>& columns_;
  const std::string& example_;
  std::optional<std::array<double, 2>> units_;
  std::array<std::vector<double>, 2> values_;
};

}  // namespace

std::array<std::vector<double>, 2> read_two_columns(const std::filesystem::path& file,
                                                    const std::array<Column, 2>& columns,
                                                    const std::string& example) {
  std::ifstream stream(file);
  ColumnReader reader(columns, example);
  std::string line;
  for (int line_number = 1; std::getline(stream, line); ++line_number) {
    line = trimmed(line_number == 1 ? without_byte_order_mark(line) : line);
    if (line.empty() || line.front() == '#') continue;
    try {
      reader.read(line);
    } catch (const std::invalid_argument& error) {
      throw base::InputError(
          fmt::format("{}, line {}: {}", file.string(), line_number, error.what()));
    }
  }
  return reader.values();
}

}  // namespace geneva::model
