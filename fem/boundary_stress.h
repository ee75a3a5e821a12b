#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <optional>
#include <vector>

#include "fem/boundary_tractions.h"
#include "fem/discretisation/vector.h"
#include "fem/elasticity/material_law.h"
#include "fem/stress_patch.h"

namespace geneva::fem {

/// A vertex as a corner of one of its cells.
template <int dim>
struct CellCorner {
  typename dealii::DoFHandler<dim>::active_cell_iterator cell;
  unsigned int vertex;
};

/// The stress at a node, and by how much each component may be off.
template <int dim>
struct RecoveredStress {
  StressVector<dim> stress, doubt;
};

template <int dim>
struct BoundaryFaceThere;

/// What the boundary knows of the stress: tractions, and the strains along smooth surfaces.
template <int dim>
class BoundaryStress {
 public:
  /// All of the same mesh, and kept by the caller.
  BoundaryStress(const Vector& displacement, const Problem<dim>& problem,
                 const BoundaryTractions<dim>& tractions);

  /// The planes of symmetry through a node.
  /// @param corners one for each of its known cells
  [[nodiscard]] std::vector<Mirror> mirrors_at(const std::vector<CellCorner<dim>>& corners) const;

  /// The axis that a face of the boundary is normal to, if it is a plane of symmetry.
  [[nodiscard]] std::optional<unsigned int> mirror_axis(
      const typename dealii::DoFHandler<dim>::active_cell_iterator& cell, unsigned int face) const;

  /// The stress at a node of the boundary.
  /// @param corners one for each of its known cells
  /// @param linear as extrapolated from inside; stays so where the tractions are not known
  [[nodiscard]] RecoveredStress<dim> at(const std::vector<CellCorner<dim>>& corners,
                                        const RecoveredStress<dim>& linear) const;

 private:
  using Corner = CellCorner<dim>;
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  using FaceThere = BoundaryFaceThere<dim>;

  [[nodiscard]] std::vector<FaceThere> faces_at(const std::vector<Corner>& corners) const;
  [[nodiscard]] FaceThere face_there(const Corner& corner, unsigned int face) const;
  [[nodiscard]] bool carries_contact(const dealii::Point<dim>& place, double face_size) const;
  [[nodiscard]] std::optional<dealii::Tensor<1, dim>> held_traction(const Corner& corner) const;
  [[nodiscard]] dealii::Tensor<1, dim> displacement_of(const Corner& corner) const;
  [[nodiscard]] std::optional<StressVector<dim>> stress_on(
      const std::vector<Corner>& corners, const std::vector<FaceThere>& faces) const;

  const Vector& displacement_;
  const Problem<dim>& problem_;
  const BoundaryTractions<dim>& tractions_;
  MaterialLaws<dim> laws_;
};

}  // namespace geneva::fem
