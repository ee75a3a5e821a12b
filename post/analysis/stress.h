#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <array>
#include <memory>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/elasticity/elasticity.h"
#include "fem/elasticity/invariants.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::post {

using fem::assembled_stress;
using fem::n_stress_components;
using fem::Stress;

/// Stress in the middle of a cell, where that of a bilinear element is most accurate; SI units.
template <int dim>
struct CellStress {
  dealii::Point<dim> centre;  ///< [m]
  double measure;             ///< area [m^2] or volume [m^3]
  double height;              ///< extent along the last axis [m]
  unsigned int body;
  Stress<dim> stress;  ///< [Pa]
};

/// Stresses of this rank's cells.
template <int dim>
std::vector<CellStress<dim>> cell_stresses(const fem::Solution<dim>& solution);

using fem::in_plane_shear;
using fem::max_shear;
using fem::principal_stresses;
using fem::von_mises;

using fem::NodalStress;

/// Recovered at the nodes, see fem::recovered_stress().
template <int dim>
NodalStress<dim> nodal_stress(const fem::Solution<dim>& solution);

/// A stress maximum and where it is; SI units.
template <int dim>
struct StressPeak {
  double value = 0.;
  std::array<double, static_cast<std::size_t>(dim)> place{};
};

/// Maximum von Mises stress at the nodes of a body, over all ranks.
template <int dim>
StressPeak<dim> peak_von_mises(const fem::Solution<dim>& solution, const NodalStress<dim>& stress,
                               unsigned int body);

/// Maximum in-plane shear stress within a distance of a point, beside no singular place, over all
/// ranks: the top of the paraboloid fitted to the cell middles within a radius of the maximum one.
StressPeak<2> peak_shear(const fem::Solution<2>& solution,
                         const std::vector<CellStress<2>>& stresses, const dealii::Point<2>& around,
                         double distance, double radius);

}  // namespace geneva::post
