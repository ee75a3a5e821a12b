#pragma once

#include <deal.II/base/types.h>

#include <set>
#include <vector>

namespace geneva::fem {

/// A set of unknowns in which those of all cells are looked up.
class MarkedUnknowns {
 public:
  explicit MarkedUnknowns(const std::set<dealii::types::global_dof_index>& unknowns)
      : is_marked_(unknowns.empty() ? 0 : *unknowns.rbegin() + 1, false) {
    for (const auto unknown : unknowns) is_marked_[unknown] = true;
  }

  [[nodiscard]] bool have(const dealii::types::global_dof_index unknown) const {
    return unknown < is_marked_.size() && is_marked_[unknown];
  }

 private:
  std::vector<bool> is_marked_;
};

}  // namespace geneva::fem
