#pragma once

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

namespace geneva::fem {

/// Number of translations and rotations, which is that of a coarse node's unknowns.
template <int dim>
inline constexpr int n_rigid_motions = dim == 2 ? 3 : 6;

/// Displacement by the unknowns of a coarse node: first its displacement, then its rotation.
template <int dim>
using RigidDisplacement = Eigen::Matrix<double, dim, n_rigid_motions<dim>>;

/// Displacement t + w x r of what stands at r from a coarse node and moves with it.
/// @param r in the unit of length of the mesh
inline RigidDisplacement<2> rigid_displacement(const dealii::Tensor<1, 2>& r) {
  RigidDisplacement<2> result;
  result << 1., 0., -r[1],  //
      0., 1., r[0];
  return result;
}
inline RigidDisplacement<3> rigid_displacement(const dealii::Tensor<1, 3>& r) {
  RigidDisplacement<3> result;
  result << 1., 0., 0., 0., r[2], -r[1],  //
      0., 1., 0., -r[2], 0., r[0],        //
      0., 0., 1., r[1], -r[0], 0.;
  return result;
}

/// Unknowns of a coarse node by those of another.
template <int dim>
using RigidMotion = Eigen::Matrix<double, n_rigid_motions<dim>, n_rigid_motions<dim>>;

/// Displacement and rotation of a coarse node that stands at r from another and moves with it.
/// @param r in the unit of length of the mesh
template <int dim>
RigidMotion<dim> rigid_motion(const dealii::Tensor<1, dim>& r) {
  RigidMotion<dim> result = RigidMotion<dim>::Identity();
  result.template topRows<dim>() = rigid_displacement(r);
  return result;
}

}  // namespace geneva::fem
