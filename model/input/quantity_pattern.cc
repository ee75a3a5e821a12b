#include "model/input/quantity_pattern.h"

#include <utility>

namespace geneva::model {

QuantityPattern::QuantityPattern(QuantityRule rule) : rule_(std::move(rule)) {}

bool QuantityPattern::match(const std::string& text) const { return !refusal(rule_, text); }

std::string QuantityPattern::description(OutputStyle /*style*/) const { return allowed(rule_); }

std::unique_ptr<dealii::Patterns::PatternBase> QuantityPattern::clone() const {
  return std::make_unique<QuantityPattern>(rule_);
}

}  // namespace geneva::model
