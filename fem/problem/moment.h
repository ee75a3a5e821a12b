#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <type_traits>

namespace geneva::fem {

/// A moment: about z in the plane, a vector in 3-D.
template <int dim>
using Moment = std::conditional_t<dim == 2, double, dealii::Tensor<1, 3>>;

/// Of a force that acts at the end of an arm.
template <int dim>
Moment<dim> moment_of(const dealii::Tensor<1, dim>& arm, const dealii::Tensor<1, dim>& force) {
  if constexpr (dim == 2)
    return arm[0] * force[1] - arm[1] * force[0];
  else
    return dealii::cross_product_3d(arm, force);
}

}  // namespace geneva::fem
