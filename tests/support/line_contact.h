#pragma once

#include "fem/problem/problem.h"
#include "loads/hertz.h"
#include "mesh/mesh_data.h"

namespace geneva::test {

/// A cylinder pressed on a block by a rigid core: Hertz's line contact (K. L. Johnson, Contact
/// Mechanics, 1985, section 4.2). The block is 8 R wide and 4 R deep and held at its bottom.
struct LineContact {
  double radius = 0.01;     ///< R of the cylinder [m]
  double core = 0.25;       ///< radius of the rigid core [R]
  double thickness = 0.01;  ///< [m]
  double force = 250.;      ///< [N]; the contact is then R/93 wide in plane strain
  fem::PlaneKind plane = fem::PlaneKind::plane_strain;
  fem::Material cylinder{2e11, 0.3};
  fem::Material block{2e11, 0.3};
  unsigned int cells_around = 24;  ///< of the cylinder
  double turn = 0.;                ///< of the cylinder's nodes, as a share of a cell
  double block_cell = 0.5;         ///< width of the block's cells [R]
  double shift = 0.;               ///< of the block's nodes, as a share of a cell
  bool block_is_source = false;
};

/// Surfaces: "cylinder" and "core" of the cylinder, "top" and "bottom" of the block.
mesh::MeshData<2> mesh_of(const LineContact& contact);

fem::Problem<2> problem_of(const LineContact& contact);

/// Hertz's solution of it.
loads::HertzLine hertz(const LineContact& contact);

}  // namespace geneva::test
