#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/trilinos_vector.h>

#include <array>
#include <memory>
#include <vector>

#include "fem/elasticity.h"
#include "fem/solution.h"

namespace geneva::post {

/// Stress in the middle of a cell, where that of a bilinear element is most accurate; SI units.
struct CellStress {
  dealii::Point<2> centre;  ///< [m]
  double area;              ///< [m^2]
  unsigned int body;
  fem::PlaneStress stress;  ///< [Pa]
};

/// Stresses of this rank's cells.
std::vector<CellStress> cell_stresses(const fem::Solution<2>& solution);

/// Principal stresses [same unit], greatest first; the out-of-plane stress is one of them.
std::array<double, 3> principal_stresses(const fem::PlaneStress& stress);
/// sqrt(((s1-s2)^2 + (s2-s3)^2 + (s3-s1)^2)/2)
double von_mises(const std::array<double, 3>& principal);
/// (s1 - s3)/2
double max_shear(const std::array<double, 3>& principal);
/// Greatest shear stress in the plane of the model, which is what Hertz's 0.300 p0 speaks of.
double in_plane_shear(const fem::PlaneStress& stress);

/// Stress at the nodes [Pa], continuous within each body: the average of the cells' stresses at the
/// node, weighted with their area. Components xx, yy, out of plane, xy.
struct NodalStress {
  std::unique_ptr<dealii::FESystem<2>> element;
  std::unique_ptr<dealii::DoFHandler<2>> dof_handler;
  dealii::TrilinosWrappers::MPI::Vector values;  ///< ghosted
};

NodalStress nodal_stress(const fem::Solution<2>& solution);

/// A stress maximum and where it is; SI units.
struct StressPeak {
  double value = 0.;
  std::array<double, 2> place{0., 0.};
};

/// Greatest von Mises stress at the nodes of a body, over all ranks.
StressPeak peak_von_mises(const fem::Solution<2>& solution, const NodalStress& stress,
                          unsigned int body);

/// Greatest in-plane shear stress within a distance of a point, over all ranks: the top of the
/// paraboloid fitted to the cell middles around the greatest one.
StressPeak peak_shear(const fem::Solution<2>& solution, const std::vector<CellStress>& stresses,
                      const dealii::Point<2>& around, double distance);

}  // namespace geneva::post
