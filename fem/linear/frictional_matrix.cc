#include "fem/linear/frictional_matrix.h"

namespace geneva::fem {

template <int dim>
FrictionalMatrix<dim>::FrictionalMatrix(const CondensedMatrix<dim>& condensed,
                                        const std::map<int, Shares>& virtual_lines)
    : condensed_(condensed), virtual_elimination_(condensed.unknowns(), virtual_lines) {}

template <int dim>
void FrictionalMatrix<dim>::vmult(Vector& result, const Vector& vector) const {
  Vector distributed(vector);
  condensed_.elimination().distribute(distributed);
  condensed_.whole().vmult(result, distributed);
  virtual_elimination_.collect(result);
}

template <int dim>
void FrictionalMatrix<dim>::residual(Vector& result, const Vector& vector,
                                     const Vector& right_hand_side) const {
  Vector distributed(vector);
  condensed_.elimination().distribute(distributed);
  condensed_.whole().residual(result, distributed, right_hand_side);
  virtual_elimination_.collect(result);
}

template class FrictionalMatrix<2>;
template class FrictionalMatrix<3>;

}  // namespace geneva::fem
