#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/units.h"

namespace geneva::model {

/// Allowed values, in SI units.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_included = true;
  bool upper_included = true;
  std::string text;  ///< "greater than 0"; empty: any value
};

Range greater_than_zero();
Range zero_or_greater();
Range between(double lower, double upper, std::string text);

/// One or more dimensional values, each with its unit, separated by commas.
struct QuantityRule {
  base::Dimension dimension = base::Dimension::dimensionless;
  Range range;
  std::vector<std::string> words;  ///< taken instead of values; an empty one: may be left out
  std::size_t count = 1;
  std::size_t most = 1;  ///< where there may be more than `count`
  bool whole = false;    ///< whole numbers, without a unit
};

/// @param words taken instead of a value
QuantityRule quantity(base::Dimension dimension, const Range& range = {},
                      std::vector<std::string> words = {});
QuantityRule positive(base::Dimension dimension, std::vector<std::string> words = {});
/// A whole number.
/// @param text the range in words
QuantityRule whole(double lower, double upper, const std::string& text);
/// Components of a vector: two in the plane, three in 3-D.
QuantityRule vector_of(base::Dimension dimension, std::vector<std::string> words = {});

/// One of a few words.
struct ChoiceRule {
  std::vector<std::string> words;
};

/// Any text.
struct TextRule {
  std::string meaning;  ///< "names separated by commas"
};

using Rule = std::variant<QuantityRule, ChoiceRule, TextRule>;

/// What the rule allows, as a sentence for the manual: "A length with its unit, greater than 0; or
/// 'default'."
std::string allowed(const Rule& rule);

/// Whether the text is one of the words that stand for values.
bool is_word(const QuantityRule& rule, const std::string& text);

/// Values in SI units.
/// @throws base::InputError with the text found and what is allowed, also where the text is a
/// word
std::vector<double> values(const QuantityRule& rule, const std::string& text);

/// Why the rule does not allow the text: the text in quotes and what is allowed; nothing if it
/// does.
std::optional<std::string> refusal(const Rule& rule, const std::string& text);

/// 'one', 'two', 'three': the words in quotes, separated by commas.
std::string listed(const std::vector<std::string>& words);

/// Parts of a list separated by commas, trimmed.
std::vector<std::string> split_list(const std::string& text);

/// Without white space at the ends.
std::string trimmed(const std::string& text);

/// Without the three bytes that spreadsheets put before UTF-8.
std::string without_byte_order_mark(const std::string& text);

}  // namespace geneva::model
