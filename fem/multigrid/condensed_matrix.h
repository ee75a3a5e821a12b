#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <map>
#include <vector>

#include "fem/multigrid/elimination.h"
#include "fem/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// E^T A E for unknowns u = E v that follow others (Shephard 1984, Linear multipoint constraints
/// applied via transformation as part of a direct stiffness assembly process), by its factors: A
/// stays when other unknowns follow. It does not see the entries of unknowns that follow others,
/// and its products are zero there.
template <int n>
class CondensedMatrix {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param whole A; no unknown follows another yet
  explicit CondensedMatrix(SymmetricMatrix<n> whole);

  /// Lets other unknowns follow others than before.
  /// @param lines of all unknowns in the rows and columns of this rank that follow others
  void eliminate(const std::map<int, Shares>& lines);

  [[nodiscard]] const SymmetricMatrix<n>& whole() const { return whole_; }
  [[nodiscard]] const Elimination& elimination() const { return elimination_; }
  [[nodiscard]] const Epetra_Map& unknowns() const { return whole_.unknowns(); }

  /// E^T A E v
  void vmult(Vector& result, const Vector& vector) const;
  /// b - E^T A E v
  /// @param right_hand_side zero at unknowns that follow others
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

  /// In the order of this rank's unknowns; that of A at those that follow others.
  [[nodiscard]] std::vector<double> diagonal() const;

 private:
  [[nodiscard]] std::map<int, double> contributions_to_diagonal() const;

  SymmetricMatrix<n> whole_;
  Elimination elimination_;
};

}  // namespace geneva::fem
