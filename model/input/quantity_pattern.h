#pragma once

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

#include "model/input/parameter_rule.h"

namespace geneva::model {

/// Matches dimensional values with their unit within a range, for dealii::ParameterHandler.
class QuantityPattern : public dealii::Patterns::PatternBase {
 public:
  explicit QuantityPattern(QuantityRule rule);

  [[nodiscard]] bool match(const std::string& text) const override;
  /// What the rule allows; the same in every style.
  [[nodiscard]] std::string description(OutputStyle style = Machine) const override;
  [[nodiscard]] std::unique_ptr<PatternBase> clone() const override;

 private:
  QuantityRule rule_;
};

}  // namespace geneva::model
