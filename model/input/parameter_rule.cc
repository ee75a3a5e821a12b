#include "model/input/parameter_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "base/errors.h"
#include "model/input/nearest_word.h"

namespace geneva::model {

namespace {

bool contains(const Range& range, double value) {
  const bool above = range.lower_included ? value >= range.lower : value > range.lower;
  const bool below = range.upper_included ? value <= range.upper : value < range.upper;
  return above && below;
}

std::string wanted_value(const QuantityRule& rule) {
  return rule.whole ? "a whole number" : base::wanted(rule.dimension);
}

/// Words that a user would write out.
std::vector<std::string> visible_words(const QuantityRule& rule) {
  std::vector<std::string> words;
  for (const std::string& word : rule.words)
    if (!word.empty()) words.push_back(word);
  return words;
}

/// ", or 'default'" at the end of a message.
std::string or_words(const QuantityRule& rule) {
  const std::vector<std::string> words = visible_words(rule);
  if (words.empty()) return "";
  return (words.size() == 1 ? ", or " : ", or one of ") + listed(words);
}

double whole_number(const std::string& text, const Range& range) {
  try {
    const double value = base::parse_quantity(text, base::Dimension::dimensionless);
    const bool is_percentage = text.find_first_of("%p") != std::string::npos;
    if (!is_percentage && value == std::floor(value)) return value;
  } catch (const std::invalid_argument&) {
    // said below, for whole numbers
  }
  throw base::InputError(fmt::format("{}: a whole number{} is wanted", base::in_quotes(text),
                                     range.text.empty() ? "" : " " + range.text));
}

double single_value(const QuantityRule& rule, const std::string& text) {
  const double value =
      rule.whole ? whole_number(text, rule.range) : base::parse_quantity(text, rule.dimension);
  if (!contains(rule.range, value))
    throw base::InputError(
        fmt::format("{}: the value must be {}", base::in_quotes(text), rule.range.text));
  return value;
}

/// "2", or "2 or 3".
std::string count_of(const QuantityRule& rule) {
  if (rule.most > rule.count + 1) return fmt::format("{} to {}", rule.count, rule.most);
  return rule.most > rule.count ? fmt::format("{} or {}", rule.count, rule.most)
                                : fmt::format("{}", rule.count);
}

std::string allowed_quantity(const QuantityRule& rule) {
  std::string text = wanted_value(rule);
  if (std::max(rule.count, rule.most) > 1)
    text = fmt::format("{} values separated by commas, each {}", count_of(rule), text);
  if (!rule.range.text.empty()) text += (rule.whole ? " " : ", ") + rule.range.text;
  const std::vector<std::string> words = visible_words(rule);
  if (!words.empty()) text += "; or " + listed(words);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

}  // namespace

Range greater_than_zero() {
  Range range;
  range.lower = 0.;
  range.lower_included = false;
  range.text = "greater than 0";
  return range;
}

Range zero_or_greater() {
  Range range;
  range.lower = 0.;
  range.text = "0 or greater";
  return range;
}

Range between(const double lower, const double upper, std::string text) {
  return {lower, upper, true, true, std::move(text)};
}

QuantityRule quantity(const base::Dimension dimension, const Range& range,
                      std::vector<std::string> words) {
  QuantityRule rule;
  rule.dimension = dimension;
  rule.range = range;
  rule.words = std::move(words);
  return rule;
}

QuantityRule positive(const base::Dimension dimension, std::vector<std::string> words) {
  return quantity(dimension, greater_than_zero(), std::move(words));
}

QuantityRule whole(const double lower, const double upper, const std::string& text) {
  QuantityRule rule = quantity(base::Dimension::dimensionless, between(lower, upper, text));
  rule.whole = true;
  return rule;
}

QuantityRule vector_of(const base::Dimension dimension, std::vector<std::string> words) {
  QuantityRule rule = quantity(dimension, Range(), std::move(words));
  rule.count = 2;
  rule.most = 3;
  return rule;
}

std::string allowed(const Rule& rule) {
  if (const auto* quantity = std::get_if<QuantityRule>(&rule)) return allowed_quantity(*quantity);
  if (const auto* choice = std::get_if<ChoiceRule>(&rule))
    return "One of " + listed(choice->words) + ".";
  std::string text = std::get<TextRule>(rule).meaning;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

bool is_word(const QuantityRule& rule, const std::string& text) {
  return std::find(rule.words.begin(), rule.words.end(), text) != rule.words.end();
}

std::vector<double> values(const QuantityRule& rule, const std::string& text) {
  const std::vector<std::string> parts =
      std::max(rule.count, rule.most) == 1 ? std::vector<std::string>{text} : split_list(text);
  if (parts.size() < rule.count || parts.size() > std::max(rule.count, rule.most))
    throw base::InputError(
        fmt::format("{}: {} values separated by a comma are wanted, each {}, for example {}",
                    base::in_quotes(text), count_of(rule), wanted_value(rule),
                    base::example_of(rule.dimension)));
  std::vector<double> result;
  for (const std::string& part : parts) {
    try {
      result.push_back(single_value(rule, part));
    } catch (const std::invalid_argument& error) {
      throw base::InputError(error.what() + or_words(rule));
    }
  }
  return result;
}

std::optional<std::string> refusal(const Rule& rule, const std::string& text) {
  if (const auto* choice = std::get_if<ChoiceRule>(&rule)) {
    const auto& words = choice->words;
    if (std::find(words.begin(), words.end(), text) != words.end()) return std::nullopt;
    const auto nearest = nearest_word(text, words);
    return fmt::format(
        "{}: one of {} is wanted{}", base::in_quotes(text), listed(words),
        nearest ? fmt::format(" (did you mean {}?)", base::in_quotes(*nearest)) : "");
  }
  const auto* quantity = std::get_if<QuantityRule>(&rule);
  if (quantity == nullptr || is_word(*quantity, text)) return std::nullopt;
  try {
    values(*quantity, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return std::nullopt;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + base::in_quotes(word);
  return text;
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    parts.push_back(trimmed(text.substr(begin, comma - begin)));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

std::string trimmed(const std::string& text) {
  const char* const white = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(white);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(white) - begin + 1);
}

std::string without_byte_order_mark(const std::string& text) {
  const std::string mark = "\xEF\xBB\xBF";
  return text.rfind(mark, 0) == 0 ? text.substr(mark.size()) : text;
}

}  // namespace geneva::model
