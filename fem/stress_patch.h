#pragma once

#include <deal.II/base/point.h>

#include <Eigen/Core>
#include <vector>

#include "fem/elasticity/elasticity.h"

namespace geneva::fem {

/// Stress in the middle of a cell, where it is most accurate.
template <int dim>
struct Sample {
  dealii::Point<dim> place;
  StressVector<dim> stress;  ///< [Pa]
};

/// A plane of symmetry.
struct Mirror {
  unsigned int axis;
  double place;
};

/// The image of a vector in a plane of symmetry.
template <int dim>
dealii::Tensor<1, dim> mirrored(dealii::Tensor<1, dim> vector, const unsigned int axis) {
  vector[axis] = -vector[axis];
  return vector;
}

/// The image of a sample: shears with the axis change their sign.
template <int dim>
Sample<dim> mirrored(const Sample<dim>& sample, const Mirror& mirror);

/// A stress that is linear around a node: its value there [Pa], then its derivatives by x, y, z.
template <int dim>
using LinearStress = Eigen::Matrix<double, dim + 1, n_stress_components<dim>>;

/// The linear stress around a place that fits the samples best, all alike; their mean if they do
/// not determine one (Zienkiewicz and Zhu 1992).
template <int dim>
LinearStress<dim> fitted(const dealii::Point<dim>& place, const std::vector<Sample<dim>>& samples);

/// By how much a linear recovery may be off [Pa]: the difference from the mean of the cells around,
/// as a share of the stress, times `share_of_relative`, of that difference; at most all of it.
template <int dim>
StressVector<dim> doubt_of_linear(const StressVector<dim>& stress, const StressVector<dim>& mean,
                                  double share_of_relative);

}  // namespace geneva::fem
