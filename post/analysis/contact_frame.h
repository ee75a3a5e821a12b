#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <utility>

#include "fem/solution.h"

namespace geneva::post {

/// Where a contact in 3-D carries its load, and how the surfaces curve there.
struct ContactFrame {
  dealii::Point<3> centre;      ///< of pressure [m]; of the whole contact where the model is a part
  dealii::Tensor<1, 3> normal;  ///< target's outward unit normal there
  dealii::Tensor<1, 3> along;   ///< unit vector along the pin (z); else of the minimum curvature
  dealii::Tensor<1, 3> across;  ///< unit vector normal to both
  double curvature_across;      ///< of both surfaces together: 1/R1 + 1/R2 [1/m]
  double curvature_along;       ///< [1/m]
  double mean_square_across;    ///< of the pressure's distances from the centre [m^2]
  double mean_square_along;     ///< [m^2]
  std::array<bool, 3> mirrored;  ///< by x, y, z: a plane of symmetry bounds the model there

  /// How many times the model's part makes up the whole contact: 1, 2, 4.
  [[nodiscard]] double parts() const;
  /// Whether a plane of symmetry cuts a direction of the contact.
  [[nodiscard]] bool is_mirrored(const dealii::Tensor<1, 3>& direction) const;
  [[nodiscard]] double depth(const dealii::Point<3>& place) const;
  [[nodiscard]] double distance_across(const dealii::Point<3>& place) const;
  [[nodiscard]] double distance_along(const dealii::Point<3>& place) const;
};

/// @return an empty frame if the contact carries no force
ContactFrame contact_frame(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact);

/// Place of a contact node [m].
dealii::Point<3> place_of(const fem::ContactNode<3>& node);

/// The contact pair of a result.
const fem::ContactPair& pair_of(const fem::Solution<3>& solution,
                                const fem::ContactResult<3>& contact);

/// Second difference of a pair's clearance over a distance to both sides of z: its curvature along
/// z [1/m].
double second_difference(const fem::ContactPair& pair, double z, double step);

/// Along which a mechanism's pin and wheel extend.
inline const dealii::Tensor<1, 3> z_axis({0., 0., 1.});

/// Lowest and highest place along a direction [m].
using Extent = std::pair<double, double>;

/// Where the surfaces face each other, with the part of the contact that a plane of symmetry has
/// cut off.
Extent whole_extent(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                    const dealii::Tensor<1, 3>& direction);

/// Where the contact carries load, with the same part.
Extent loaded_extent(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                     const dealii::Tensor<1, 3>& direction);

/// Length along z over which source and target face each other [m], that of the whole.
double common_length(const fem::ContactResult<3>& contact, const ContactFrame& frame);

}  // namespace geneva::post
