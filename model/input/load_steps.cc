#include "model/input/load_steps.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "base/errors.h"
#include "base/units.h"
#include "model/input/parameter_rule.h"

namespace geneva::model {

namespace {

std::vector<std::string> loads_of_heading(const std::string& line) {
  std::vector<std::string> parts = split_list(line);
  if (parts.size() < 2 || parts.front().rfind("time", 0) != 0)
    throw base::InputError(fmt::format(
        "the heading is {}: 'time [s], LOAD, LOAD' is wanted, with the names of 'Loads', "
        "or 'LOAD x' and 'LOAD y' for components of a traction",
        base::in_quotes(line)));
  parts.erase(parts.begin());
  if (std::set<std::string>(parts.begin(), parts.end()).size() < parts.size())
    throw base::InputError(
        fmt::format("the heading is {}: a load stands there twice", base::in_quotes(line)));
  return parts;
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
  double last = -std::numeric_limits<double>::infinity();
  std::string line;
  for (int line_number = 1; std::getline(stream, line); ++line_number) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    try {
      if (steps.loads.empty()) {
        steps.loads = loads_of_heading(line);
        continue;
      }
      std::vector<double> row = numbers_of(line, steps.loads.size() + 1);
      if (row.front() <= last)
        throw base::InputError(
            fmt::format("the time {:.6g} does not come after {:.6g}", row.front(), last));
      last = row.front();
      row.erase(row.begin());
      steps.factors.push_back(row);
    } catch (const base::InputError& error) {
      throw base::InputError(
          fmt::format("{}, line {}: {}", file.string(), line_number, error.what()));
    }
  }
  if (steps.factors.empty())
    throw base::InputError(fmt::format("{}: there is no load step in it", file.string()));
  return steps;
}

}  // namespace geneva::model
