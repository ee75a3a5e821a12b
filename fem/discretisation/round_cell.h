#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace geneva::fem {

/// Whether a face at the boundary, or in 3-D one of its lines, stands for a round curve or surface.
template <typename Face>
bool is_round(const Face& face) {
  constexpr dealii::types::manifold_id straight = 0;
  const dealii::types::manifold_id manifold = face->manifold_id();
  return face->at_boundary() && manifold != dealii::numbers::flat_manifold_id &&
         manifold != straight;
}

/// The middle of the curve between two points of a round surface. Not every manifold knows
/// Manifold::get_intermediate_point().
template <int dim>
dealii::Point<dim> middle_of_curve(const dealii::Manifold<dim>& surface,
                                   const dealii::Point<dim>& begin, const dealii::Point<dim>& end);

/// The longest line of a round face of a cell over the least radius of those of its lines that bend
/// into the cell, as a notch's do; 0 if none does.
double length_over_notch_radius(const dealii::Triangulation<3>::cell_iterator& cell,
                                unsigned int face);

/// Numbers along each direction of a corner of a cell's parts; in the plane the last is 0.
using PartCorner = std::array<unsigned int, 3>;

/// A cell whose faces at round surfaces are those surfaces: its reference points are moved by what
/// lies between the surface and the face, the less the farther from the face they are (Gordon and
/// Hall 1973). For what is shown; the cells that are solved have straight edges.
template <int dim>
class RoundCell {
 public:
  using Cell = typename dealii::Triangulation<dim>::cell_iterator;

  explicit RoundCell(const Cell& cell);

  /// Whether any face is round; else there is one part in every direction.
  [[nodiscard]] bool is_round() const { return !faces_.empty(); }

  /// Into how many parts along each reference direction the cell is divided, so that chords of its
  /// round edges turn by 2.5 degrees at most.
  [[nodiscard]] const std::array<unsigned int, static_cast<std::size_t>(dim)>& parts() const {
    return parts_;
  }

  /// The first corner of every part, the first direction fastest.
  [[nodiscard]] std::vector<PartCorner> first_corners() const;

  /// Another corner of the part with this first one, in lexicographic order.
  [[nodiscard]] static PartCorner corner_of_part(PartCorner first, unsigned int corner);

  /// The corner of parts at a vertex of the cell.
  [[nodiscard]] PartCorner at_vertex(unsigned int vertex) const;

  /// Reference point of a corner of parts.
  [[nodiscard]] dealii::Point<dim> reference(const PartCorner& corner) const;

  /// Place of a reference point, in the units of the triangulation.
  [[nodiscard]] dealii::Point<dim> place(const dealii::Point<dim>& reference) const;

 private:
  Cell cell_;
  std::vector<unsigned int> faces_;  ///< the round ones
  std::array<unsigned int, static_cast<std::size_t>(dim)> parts_;
};

}  // namespace geneva::fem
