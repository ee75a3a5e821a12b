#include "app/motion_table.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/parameter_rule.h"
#include "post/units.h"

namespace geneva::app {

namespace {

/// SI value of one unit of a column, from "name [unit]".
double unit_of(const std::string& heading, const std::string& name,
               const post::Dimension dimension) {
  const std::size_t open = heading.find('[');
  if (trimmed(heading.substr(0, open)) != name || open == std::string::npos ||
      heading.back() != ']')
    throw std::invalid_argument(
        fmt::format("the heading is {}: 'time [s], angle [deg]' is wanted, with any units of time "
                    "and angle",
                    post::in_quotes(heading)));
  return post::parse_quantity("1 " + heading.substr(open + 1, heading.size() - open - 2),
                              dimension);
}

std::optional<double> number(const std::string& text) {
  double value = 0.;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reads line after line; the first one that is not empty is the heading.
class TableReader {
 public:
  void read(const std::string& line) {
    const std::vector<std::string> parts = split_list(line);
    if (parts.size() != 2)
      throw std::invalid_argument(
          fmt::format("{} is not two columns separated by a comma", post::in_quotes(line)));
    if (!units_) {
      units_ = {unit_of(parts[0], "time", post::Dimension::time),
                unit_of(parts[1], "angle", post::Dimension::angle)};
      return;
    }
    const auto time = number(parts[0]);
    const auto angle = number(parts[1]);
    if (!time || !angle)
      throw std::invalid_argument(
          fmt::format("{} is not two numbers separated by a comma", post::in_quotes(line)));
    table_.times.push_back(*time * units_->first);
    table_.angles.push_back(*angle * units_->second);
  }

  [[nodiscard]] const MotionTable& table() const { return table_; }

 private:
  std::optional<std::pair<double, double>> units_;
  MotionTable table_;
};

}  // namespace

MotionTable read_motion_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  TableReader reader;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    try {
      reader.read(line);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("{}, line {}: {}", file.string(), number, error.what()));
    }
  }
  return reader.table();
}

}  // namespace geneva::app
