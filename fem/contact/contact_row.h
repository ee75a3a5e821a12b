#pragma once

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace geneva::fem {

/// Orthonormal directions at a node of a contact.
template <int dim>
struct ContactFrame {
  dealii::Tensor<1, dim> normal;  ///< from the target to the source
  /// In the plane the normal turned counter-clockwise; in 3-D the first is across the axis that is
  /// farthest from the normal, and normal, first and second are right-handed.
  std::array<dealii::Tensor<1, dim>, static_cast<std::size_t>(dim - 1)> tangents;
};

inline ContactFrame<2> frame_along(const dealii::Tensor<1, 2>& normal) {
  return {normal, {dealii::Tensor<1, 2>({-normal[1], normal[0]})}};
}

inline ContactFrame<3> frame_along(const dealii::Tensor<1, 3>& normal) {
  unsigned int farthest = 0;
  for (unsigned int axis = 1; axis < 3; ++axis)
    if (std::abs(normal[axis]) < std::abs(normal[farthest])) farthest = axis;
  dealii::Tensor<1, 3> axis;
  axis[farthest] = 1.;
  dealii::Tensor<1, 3> first = dealii::cross_product_3d(normal, axis);
  first /= first.norm();
  return {normal, {first, dealii::cross_product_3d(normal, first)}};
}

/// What the displacements of a source node and of the target around it have to do with each other
/// (Popp, Gee and Wall 2009, Eqs. 12 - 14): their difference, averaged with the node's dual basis
/// function psi_j, is (D_j u_j - sum_k M_jk u_k)/D_j; along the normal it changes the gap, along
/// the tangents it is the slip.
template <int dim>
struct ContactRow {
  unsigned int node = 0;    ///< j, of the source surface
  double weight = 0.;       ///< D_j = integral of N_j over the overlap, times the out-of-plane
                            ///< measure
  ContactFrame<dim> frame;  ///< its normal averaged with psi_j
  double initial_gap = 0.;  ///< integral of psi_j times the initial gap; positive when open
  std::vector<std::pair<unsigned int, double>>
      coupling;  ///< (k, of the target surface; M_jk = integral of psi_j N_k)
};

}  // namespace geneva::fem
