#include "model/input/variation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/errors.h"
#include "base/units.h"
#include "model/input/parameter_rule.h"

namespace geneva::model {

namespace {

constexpr std::size_t most_values = 10000;
constexpr std::size_t most_points = 100000;

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw base::InputError(
      fmt::format("--set {}: {}; wanted is 'SECTION/PARAMETER = FIRST .. LAST, NUMBER' or '... = "
                  "VALUE; VALUE', "
                  "for example 'Mechanism/Pin diameter = 8 mm .. 14 mm, 7'",
                  base::in_quotes(text), reason));
}

struct End {
  double number;
  std::string unit;
};

std::optional<End> read_end(const std::string& text) {
  End end{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), end.number);
  if (error != std::errc() || !std::isfinite(end.number)) return std::nullopt;
  end.unit = trimmed(std::string(rest, text.data() + text.size()));
  return end;
}

std::vector<std::string> split(const std::string& text, const char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = text.find(separator); at != std::string::npos;
       at = text.find(separator, begin)) {
    parts.push_back(trimmed(text.substr(begin, at - begin)));
    begin = at + 1;
  }
  parts.push_back(trimmed(text.substr(begin)));
  return parts;
}

/// "FIRST .. LAST, NUMBER[, log]"
std::vector<std::string> range(const std::string& text, const std::string& whole) {
  const std::size_t dots = text.find("..");
  const std::vector<std::string> parts = split(text.substr(dots + 2), ',');
  const auto first = read_end(trimmed(text.substr(0, dots)));
  const auto last = read_end(parts[0]);
  if (!first || !last) refuse(whole, "the ends of a range are numbers with their units");
  if (first->unit != last->unit) refuse(whole, "both ends of a range have the same unit");
  const bool is_log = parts.size() == 3 && parts[2] == "log";
  if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && !is_log))
    refuse(whole, "a range is followed by the number of its values, and maybe by 'log'");
  const auto count = read_end(parts[1]);
  if (!count || !count->unit.empty() || count->number != std::floor(count->number) ||
      count->number < 2. || count->number > static_cast<double>(most_values))
    refuse(whole, fmt::format("{} is no whole number of values from 2 to {}",
                              base::in_quotes(parts[1]), most_values));
  if (is_log && first->number * last->number <= 0.)
    refuse(whole, "equal ratios want two ends of one sign");
  std::vector<std::string> values;
  const auto steps = static_cast<int>(count->number) - 1;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double value = is_log ? first->number * std::pow(last->number / first->number, share)
                                : (1. - share) * first->number + share * last->number;
    const double rounding = 1e-12 * (std::abs(first->number) + std::abs(last->number));
    values.push_back(
        trimmed(fmt::format("{:.10g} {}", std::abs(value) < rounding ? 0. : value, first->unit)));
  }
  return values;
}

}  // namespace

Variation read_variation(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) refuse(text, "there is no '='");
  std::vector<std::string> path = split(text.substr(0, sign), '/');
  if (std::any_of(path.begin(), path.end(), [](const std::string& part) { return part.empty(); }))
    refuse(text, "a parameter has no name");
  Variation variation;
  variation.name = path.back();
  path.pop_back();
  variation.section = path;
  const std::string value = trimmed(text.substr(sign + 1));
  if (value.empty()) refuse(text, "there is no value");
  variation.values = value.find("..") != std::string::npos ? range(value, text) : split(value, ';');
  return variation;
}

std::vector<std::vector<std::string>> combinations(const std::vector<Variation>& variations) {
  for (std::size_t i = 0; i < variations.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (variations[i].section == variations[j].section &&
          variations[i].name == variations[j].name)
        throw base::InputError(
            fmt::format("--set: {} is set twice", base::in_quotes(variations[i].name)));
  std::vector<std::vector<std::string>> points{{}};
  for (const Variation& variation : variations) {
    if (points.size() * variation.values.size() > most_points)
      throw base::InputError(
          fmt::format("--set: there are more than {} combinations", most_points));
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& point : points)
      for (const std::string& value : variation.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

ParameterText varied(ParameterText text, const std::vector<Variation>& variations,
                     const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < variations.size(); ++i) {
    const Variation& variation = variations[i];
    const auto found = std::find_if(
        text.assignments.begin(), text.assignments.end(), [&](const Assignment& assignment) {
          return assignment.section == variation.section && assignment.name == variation.name;
        });
    const Assignment changed{variation.section, variation.name, values[i], 0};
    if (found == text.assignments.end())
      text.assignments.push_back(changed);
    else
      *found = changed;
  }
  return text;
}

}  // namespace geneva::model
