#pragma once

#include <map>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/condensed_matrix.h"

namespace geneva::fem {

/// W^T A E for displacements u = E v and virtual displacements W w on which the tractions of a
/// contact with friction do no work (Hueber, Stadler and Wohlmuth 2008): as sparse as E^T A E,
/// which it differs from by the coefficient of friction in the rows of the contact, and not
/// symmetric.
template <int dim>
class FrictionalMatrix {
 public:
  /// @param condensed E^T A E, which has to outlive this
  /// @param virtual_lines W, of the unknowns that E constrains
  FrictionalMatrix(const CondensedMatrix<dim>& condensed,
                   const std::map<int, Shares>& virtual_lines);

  /// W
  [[nodiscard]] const Elimination& virtual_elimination() const { return virtual_elimination_; }

  /// W^T A E v
  void vmult(Vector& result, const Vector& vector) const;
  /// b - W^T A E v
  /// @param right_hand_side zero at constrained unknowns
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

 private:
  const CondensedMatrix<dim>& condensed_;
  Elimination virtual_elimination_;
};

}  // namespace geneva::fem
