#include "post/report/html/shown_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::UnitSystem;

namespace {

constexpr const char* thin_space = "\u202f";  ///< narrow, without a line break

}  // namespace

std::vector<double> round_numbers(const double from, const double to, const int count) {
  constexpr double rounding = 1e-9;  // between numbers that differ by less there is none
  if (!(to - from > rounding * std::max(std::abs(from), std::abs(to)))) return {};
  const double raw = (to - from) / count;
  const double power = std::pow(10., std::floor(std::log10(raw)));
  const double step = power * (raw / power < 1.5   ? 1.
                               : raw / power < 3.5 ? 2.
                               : raw / power < 7.5 ? 5.
                                                   : 10.);
  std::vector<double> numbers;
  for (auto i = static_cast<long long>(std::ceil(from / step)); static_cast<double>(i) * step <= to;
       ++i)
    numbers.push_back(static_cast<double>(i) * step);
  return numbers;
}

std::string significant(const double value, const int digits) {
  const double size = std::abs(value);
  if (size < 1e-12) return "0";
  const double whole = std::pow(10., digits);
  if (!(size >= whole - 0.5 && size < 1e12)) return grouped(fmt::format("{:.{}g}", value, digits));
  const double unit = std::pow(10., std::floor(std::log10(size)) + 1. - digits);
  return grouped(fmt::format("{:.0f}", unit * std::round(value / unit)));
}

std::vector<double> numbers_that_fit(const double from, const double to, const int count,
                                     const int digits, const std::size_t letters) {
  constexpr std::size_t apart = 2;
  for (int fewer = count; fewer > 1; --fewer) {
    std::vector<double> numbers = round_numbers(from, to, fewer);
    std::size_t needed = 0;
    for (const double number : numbers) needed += n_letters(significant(number, digits)) + apart;
    if (needed <= letters) return numbers;
  }
  return round_numbers(from, to, 1);
}

std::size_t n_letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](const char byte) {
    constexpr unsigned int kind = 0xc0;
    constexpr unsigned int continuation = 0x80;
    return (static_cast<unsigned char>(byte) & kind) != continuation;
  }));
}

std::string grouped(const std::string& number) {
  const std::size_t begin = number.find_first_of("0123456789");
  if (begin == std::string::npos) return number;
  const std::size_t end = std::min(number.find_first_not_of("0123456789", begin), number.size());
  std::string result = number;
  if (end - begin < 5) return result;
  for (std::size_t at = end; at > begin + 3; at -= 3) result.insert(at - 3, thin_space);
  return result;
}

double number_of(const nlohmann::json& quantity) {
  if (quantity.is_null()) return std::nan("");
  return (quantity.is_object() ? quantity.at("value") : quantity).get<double>();
}

double in_units(const nlohmann::json& quantity, const Dimension dimension, const UnitSystem units) {
  return number_of(quantity) * output_unit(units, dimension).factor;
}

std::string shown(const nlohmann::json& quantity, const Dimension dimension,
                  const UnitSystem units) {
  return quantity.is_null() ? "–" : significant(in_units(quantity, dimension, units), 5);
}

std::string shown_error(const nlohmann::json& error) {
  if (error.is_null()) return "";
  const double percent = 100. * error.get<double>();
  if (!(percent < 100.)) return "not known";
  return percent < 0.005 ? "± 0.00 %" : fmt::format("± {:.2g} %", percent);
}

std::string shown_unit(const std::string& unit) {
  std::string shown;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool is_power = unit[i] == '^' && i + 1 < unit.size();
    if (is_power && unit[i + 1] == '2')
      shown += "²";
    else if (is_power && unit[i + 1] == '3')
      shown += "³";
    else
      shown += unit[i] == '.' || unit[i] == ' ' ? "·" : std::string(1, unit[i]);
    if (is_power && (unit[i + 1] == '2' || unit[i + 1] == '3')) ++i;
  }
  return shown;
}

std::string shown_input(const std::string& value) {
  constexpr int most_digits = 6;
  std::string text;
  bool is_unit = false;  // what follows a number
  std::istringstream words(value);
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    const std::string rest = end;
    const bool is_number = end != word.c_str() && (rest.empty() || rest == "," || rest == ";");
    text += (text.empty() ? "" : " ") + (is_number && std::isfinite(number)
                                             ? significant(number, most_digits) + rest
                                         : is_unit ? shown_unit(word)
                                                   : word);
    is_unit = is_number;
  }
  return text;
}

std::string labelled(const std::string& name, const Dimension dimension, const UnitSystem units) {
  const std::string unit = output_unit(units, dimension).name;
  return unit.empty() ? name : fmt::format("{} [{}]", name, shown_unit(unit));
}

}  // namespace geneva::post
