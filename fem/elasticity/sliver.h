#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <cstddef>

#include "fem/elasticity/material_law.h"

namespace geneva::fem {

/// The slivers between the flat faces of cells and the round surfaces that those stand for.
///
/// A face whose corners lie on a round surface leaves a sliver of the body out, or a hollow one
/// has too much. It is thin and its outside is loaded by the given traction alone: it is stretched
/// as the face is, and works as a membrane of its thickness d, negative where it is too much,
///
///   K_ab = integral of d sigma(grad_s phi_b) : grad_s phi_a over the face.
///
/// This transfers the boundary condition from the true surface to the face (Bramble, Dupont and
/// Thomee 1972, to the first order in d). Without it a step of the edges' length along a surface is
/// a step of its mean radius, and the stress beside it is off by a share of the order of one edge
/// over the radius.
template <int dim>
class Slivers {
 public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// @param problem in the units of the triangulation
  explicit Slivers(const Problem<dim>& problem);

  /// Adds the slivers' stiffness to that of a cell.
  void add_stiffness(const Cell& cell, dealii::FullMatrix<double>& stiffness) const;

  /// Adds what a traction on the outside of a sliver loads the cell with, beyond the traction
  /// itself: the sliver gives way to it sideways.
  /// @param pressure, shear the traction is shear - pressure * outward normal [units of the
  /// problem]
  void add_load(const Cell& cell, unsigned int face, double pressure,
                const dealii::Tensor<1, dim>& shear, dealii::Vector<double>& load) const;

 private:
  static constexpr std::size_t n_vertices = dealii::GeometryInfo<dim>::vertices_per_face;
  static constexpr std::size_t n_points = n_vertices;  ///< two along each axis of a face

  /// A Gauss point of a face.
  struct FacePoint {
    dealii::Tensor<1, dim> normal;                             ///< outward
    std::array<dealii::Tensor<1, dim>, n_vertices> gradients;  ///< along the face, by its vertices
    std::array<double, n_vertices> hoop;  ///< strain by a displacement along x; 0
                                          ///< unless axisymmetric
    double volume;                        ///< weight times thickness of the sliver, signed
  };

  [[nodiscard]] std::array<FacePoint, n_points> points(const Cell& cell, unsigned int face) const;
  static constexpr int n_face_dofs = dim * static_cast<int>(n_vertices);
  using FaceStrains = Eigen::Matrix<double, n_stress_components<dim>, n_face_dofs>;

  /// Strains by unit displacements of the face's vertices.
  static FaceStrains strains(const FacePoint& point);

  /// Of the cell's unknowns that of a face.
  static unsigned int cell_dof(unsigned int face, int face_dof);

  Problem<dim> problem_;
  MaterialLaws<dim> laws_;
};

}  // namespace geneva::fem
