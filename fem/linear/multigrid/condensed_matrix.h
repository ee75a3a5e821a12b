#pragma once

#include <map>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/elimination.h"
#include "fem/linear/multigrid/symmetric_matrix.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// E^T A E for constrained unknowns u = E v (Shephard 1984, Linear multipoint constraints
/// applied via transformation as part of a direct stiffness assembly process), by its factors: A
/// stays when other unknowns are constrained. It does not see the entries of constrained unknowns,
/// and its products are zero there.
template <int n>
class CondensedMatrix {
 public:
  /// @param whole A; no unknown follows another yet
  explicit CondensedMatrix(SymmetricMatrix<n> whole);

  /// Constrains other unknowns than before.
  /// @param lines of all constrained unknowns in the rows and columns of this rank
  void eliminate(const std::map<int, Shares>& lines);

  [[nodiscard]] const SymmetricMatrix<n>& whole() const { return whole_; }
  [[nodiscard]] const Elimination& elimination() const { return elimination_; }
  [[nodiscard]] const UnknownRanges& unknowns() const { return whole_.unknowns(); }

  /// E^T A E v
  void vmult(Vector& result, const Vector& vector) const;
  /// b - E^T A E v
  /// @param right_hand_side zero at constrained unknowns
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

  /// In the order of this rank's unknowns; that of A at the constrained ones.
  [[nodiscard]] std::vector<double> diagonal() const;

 private:
  [[nodiscard]] std::map<int, double> contributions_to_diagonal() const;

  SymmetricMatrix<n> whole_;
  Elimination elimination_;
};

}  // namespace geneva::fem
