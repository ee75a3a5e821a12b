#pragma once

#include <deal.II/base/point.h>

#include <set>
#include <vector>

#include "fem/solution.h"

namespace geneva::fem {

/// The stress that the contacts' forces would make in a half-space, without edges, bending and
/// everything else that belongs to the bodies.
///
/// The forces are those of the nodes, each on a half-space straight below it: in the plane 2 P/(pi
/// r) along the radius (Flamant 1892; Johnson, Contact Mechanics, 2.2), in 3-D and around an axis
/// 3 F/(2 pi r^2) (Boussinesq at nu = 1/2; 3.2). Under and beside the contact, where they come from
/// all directions, their sizes add up. In 3-D a node's force is spread over its area's length. They
/// act in the bodies of their contact only; in a body that no contact presses all of them, since it
/// has but the rounding of stresses. Where a contact in 3-D reaches the end of a body, an edge or a
/// plane of symmetry, its forces act in that once more, mirrored there: on the face of a
/// quarter-space a force makes about twice the stress that it makes in a half-space (Hetenyi, J.
/// Appl. Mech. 37, 1970).
template <int dim>
class ContactsOwnField {
 public:
  explicit ContactsOwnField(const Solution<dim>& solution);

  /// Von Mises stress [Pa].
  /// @param place [m]
  [[nodiscard]] double von_mises(const dealii::Point<dim>& place, unsigned int body) const;

 private:
  struct PointForce {
    dealii::Point<dim> place;  ///< [m]
    double size;               ///< [N], in the plane per thickness [N/m]
  };

  /// Forces of neighbours, which far away act as one in their middle.
  struct ForceGroup {
    PointForce sum;
    double extent = 0.;  ///< maximum distance of a force from the middle [m]
    std::vector<PointForce> forces;
  };

  struct ContactForces {
    std::set<unsigned int> bodies;
    std::vector<ForceGroup> groups;
  };

  static std::vector<PointForce> mirrored(std::vector<PointForce> forces, unsigned int axis,
                                          double end);
  static ForceGroup group_of(std::vector<PointForce> forces);
  static std::vector<ForceGroup> groups_of(std::vector<PointForce> forces);

  bool is_line_;
  std::vector<double> along_thickness_;  ///< by body: sigma_zz over sigma_xx + sigma_yy
  std::vector<ContactForces> contacts_;
  std::vector<ContactForces> images_;  ///< of them
};

/// A place is outside of the contacts' own field where that would make less than a share of the von
/// Mises stress there; with the other two shares it is seen how much a figure depends on the
/// choice.
struct OwnFieldShare {
  static constexpr double least = 0.35;
  static constexpr double usual = 0.5;
  static constexpr double most = 0.7;
};

}  // namespace geneva::fem
