#pragma once

#include <cmath>

namespace geneva::fem {

/// What is stored in the bodies and what has been done to them since they were undisplaced, of the
/// modelled part, in one unit of energy.
struct Energy {
  double stored = 0.;    ///< elastic, u.K u/2, >= 0
  double work = 0.;      ///< of loads, supports and ties
  double released = 0.;  ///< by the contacts: minus the work of pressure and friction
  double greatest = 0.;  ///< of the three so far, in magnitude

  /// What is neither stored nor released over the greatest of them; 0 in exact arithmetic, since
  /// the bodies are linear and forces act with the mean of an instant and the one before.
  [[nodiscard]] double imbalance() const {
    return greatest > 0. ? std::abs(work - stored - released) / greatest : 0.;
  }

  /// In units that are so many of the new ones.
  [[nodiscard]] Energy times(const double factor) const {
    return {stored * factor, work * factor, released * factor, greatest * factor};
  }
};

}  // namespace geneva::fem
