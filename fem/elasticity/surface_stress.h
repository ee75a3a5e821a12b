#pragma once

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

#include "fem/elasticity/material_law.h"

namespace geneva::fem {

/// A vertex of a smooth surface near the one in question: where it lies from there, and how far it
/// has moved beyond it.
template <int dim>
struct SurfaceNeighbour {
  dealii::Tensor<1, dim> offset;
  dealii::Tensor<1, dim> displacement;  ///< less that of the vertex in question
};

/// Displacement gradient along the surface, (du/ds) (ds/dx), from a polynomial of second degree
/// through the vertex in question that fits its neighbours best; place and displacement are fitted
/// alike, so that rigid motions have no strain. What it gives along the normal means nothing.
/// @param normal unit vector
/// @return nothing if the neighbours do not determine it
template <int dim>
std::optional<dealii::Tensor<2, dim>> surface_gradient(
    const dealii::Tensor<1, dim>& normal, const std::vector<SurfaceNeighbour<dim>>& neighbours);

/// Stress [Pa] at a surface: its strains along the surface are given, and the others such that
/// stress . normal = traction.
/// @param gradient of the displacement; only its part along the surface counts
/// @param hoop strain out of the plane of the model; 0 unless it is axisymmetric, not used in 3-D
/// @param traction [Pa]
template <int dim>
StressVector<dim> surface_stress(const MaterialLaw<dim>& law,
                                 const dealii::Tensor<2, dim>& gradient, double hoop,
                                 const dealii::Tensor<1, dim>& normal,
                                 const dealii::Tensor<1, dim>& traction);

/// What a tangent C is for strains of a surface without traction, C - C N (N^T C N)^-1 N^T C with
/// the strains N that involve the normal: those cause no stress.
/// @param tangent symmetric [Pa]
/// @param normal unit vector
template <int dim>
Tangent<dim> surface_tangent(const Tangent<dim>& tangent, const dealii::Tensor<1, dim>& normal);

/// Strain of a displacement gradient, with shears twice the tensor's.
/// @param hoop strain out of the plane of the model; not used in 3-D
template <int dim>
StressVector<dim> strain_of(const dealii::Tensor<2, dim>& gradient, double hoop);

/// stress . normal [Pa]
template <int dim>
dealii::Tensor<1, dim> traction_of(const StressVector<dim>& stress,
                                   const dealii::Tensor<1, dim>& normal);

}  // namespace geneva::fem
