#include "model/input/load_steps.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/errors.h"
#include "base/units.h"
#include "model/input/parameter_rule.h"

namespace geneva::model {

namespace {

/// Seconds in one unit of the column of times, "time [ms]"; nothing of another column.
std::optional<double> unit_of_time(const std::string& heading) {
  const std::string name = "time [";
  if (heading.rfind(name, 0) != 0 || heading.back() != ']') return std::nullopt;
  const std::string unit = heading.substr(name.size(), heading.size() - name.size() - 1);
  return base::parse_quantity("1 " + unit, base::Dimension::time);
}

/// What the heading says.
struct Heading {
  double unit_of_time;  ///< [s]
  std::vector<std::string> loads;
};

void refuse_repeated(const std::vector<std::string>& loads, const std::string& line) {
  const std::set<std::string> names(loads.begin(), loads.end());
  if (names.size() < loads.size())
    throw base::InputError(
        fmt::format("the heading is {}: a load stands there twice", base::in_quotes(line)));
  for (const std::string& name : loads)
    for (const char* const component : {" x", " y", " z"})
      if (names.count(name + component) > 0)
        throw base::InputError(
            fmt::format("the heading is {}: '{}' multiplies all of the load, '{}{}' a component of "
                        "it; give one "
                        "of them",
                        base::in_quotes(line), name, name, component));
}

Heading heading_of(const std::string& line) {
  std::vector<std::string> parts = split_list(line);
  const auto unit = parts.size() < 2 ? std::nullopt : unit_of_time(parts.front());
  if (!unit)
    throw base::InputError(fmt::format(
        "the heading is {}: 'time [s], LOAD, LOAD' is wanted, with the names of 'Loads', "
        "or 'LOAD x' and 'LOAD y' for components of a traction",
        base::in_quotes(line)));
  parts.erase(parts.begin());
  refuse_repeated(parts, line);
  return {*unit, parts};
}

std::vector<double> numbers_of(const std::string& line, const std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : split_list(line)) {
    double value = 0.;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || !std::isfinite(value))
      throw base::InputError(fmt::format("{} is no number; a row is {} numbers separated by commas",
                                         base::in_quotes(part), count));
    numbers.push_back(value);
  }
  if (numbers.size() != count)
    throw base::InputError(fmt::format("{} are {} numbers; a row is {} numbers, as the heading has",
                                       base::in_quotes(line), numbers.size(), count));
  return numbers;
}

}  // namespace

LoadSteps read_load_steps(const std::filesystem::path& file) {
  std::ifstream stream(file);
  LoadSteps steps;
  std::optional<Heading> heading;
  double last = -std::numeric_limits<double>::infinity();
  std::string line;
  for (int line_number = 1; std::getline(stream, line); ++line_number) {
    line = trimmed(line_number == 1 ? without_byte_order_mark(line) : line);
    if (line.empty() || line.front() == '#') continue;
    try {
      if (!heading) {
        heading = heading_of(line);
        continue;
      }
      std::vector<double> row = numbers_of(line, heading->loads.size() + 1);
      if (row.front() <= last)
        throw base::InputError(
            fmt::format("the time {:.6g} does not come after {:.6g}", row.front(), last));
      last = row.front();
      steps.times.push_back(last * heading->unit_of_time);
      row.erase(row.begin());
      steps.factors.push_back(row);
    } catch (const std::invalid_argument& error) {
      throw base::InputError(
          fmt::format("{}, line {}: {}", file.string(), line_number, error.what()));
    }
  }
  if (heading) steps.loads = heading->loads;
  if (steps.factors.empty())
    throw base::InputError(fmt::format("{}: there is no load step in it", file.string()));
  return steps;
}

}  // namespace geneva::model
