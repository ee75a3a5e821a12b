#pragma once

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "fem/problem.h"
#include "fem/stiffness_store.h"

namespace geneva::fem {

/// Lame constants of an isotropic material in a plane model (Timoshenko and Goodier, Theory of
/// Elasticity, 7 - 17).
struct Lame {
  double lambda;        ///< nu E/((1 + nu)(1 - 2 nu)) [Pa]
  double mu;            ///< E/(2 (1 + nu)) [Pa]
  double lambda_plane;  ///< acts on the in-plane strains: lambda, or 2 lambda mu/(lambda + 2 mu) in
                        ///< plane stress [Pa]
};

Lame lame(const Material& material, PlaneKind plane);

/// Stress [Pa], tension positive: the in-plane tensor and the normal stress out of the plane.
struct PlaneStress {
  dealii::SymmetricTensor<2, 2> in_plane;
  double out_of_plane;  ///< sigma_zz; in an axisymmetric model the hoop stress
};

/// Hooke's law for the in-plane strain and the hoop strain u_r/r (0 unless axisymmetric).
PlaneStress stress(const Lame& lame, PlaneKind plane, const dealii::SymmetricTensor<2, 2>& strain,
                   double hoop_strain);

/// Hooke's law in space.
dealii::SymmetricTensor<2, 3> stress(const Lame& lame, const dealii::SymmetricTensor<2, 3>& strain);

/// Out-of-plane measure of a point: the thickness, or 2 pi r in an axisymmetric model; 1 in space.
template <int dim>
double out_of_plane_measure(const Problem<dim>& problem, const dealii::Point<dim>& point);

/// Stiffness matrix and load vector of one cell, before any constraint.
struct CellSystem {
  dealii::FullMatrix<double> stiffness;
  dealii::Vector<double> load;
  std::vector<dealii::types::global_dof_index> dofs;
};

/// The systems of this rank's cells, in the order of its active cell iterators: K_e u_e = f_e of
/// the principle of virtual work, with body forces and surface loads.
/// @param problem in the units of the triangulation
/// @param surfaces boundary names by boundary id
/// @param stored matrices of an earlier mesh of the same problem, used for the cells that it had
template <int dim>
std::vector<CellSystem> cell_systems(const dealii::DoFHandler<dim>& dof_handler,
                                     const Problem<dim>& problem,
                                     const std::vector<std::string>& surfaces,
                                     StiffnessStore<dim> stored = {});

/// The stiffness matrices out of this rank's systems, for the next mesh.
template <int dim>
StiffnessStore<dim> stored_stiffness(const dealii::DoFHandler<dim>& dof_handler,
                                     std::vector<CellSystem> systems);

}  // namespace geneva::fem
