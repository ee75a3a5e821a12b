#pragma once

#include <deal.II/fe/fe_system.h>

#include <memory>

namespace geneva::fem {

/// Bilinear or trilinear functions for each of some components.
/// @throws std::bad_alloc also where deal.II loses it: half an element reads what it has not
template <int dim>
std::unique_ptr<dealii::FESystem<dim>> linear_element(unsigned int n_components);

}  // namespace geneva::fem
