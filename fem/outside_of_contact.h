#pragma once

#include <vector>

#include "fem/contacts_own_field.h"
#include "fem/singular_places.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

template <int dim>
using StressCell = typename dealii::DoFHandler<dim>::active_cell_iterator;

/// Where maximum stresses are looked for: outside of the contacts' own field and of the
/// surroundings of singular places.
template <int dim>
class OutsideOfContact {
 public:
  /// @param singular lives as long as this
  OutsideOfContact(const Solution<dim>& solution, const std::vector<SingularPlace<dim>>& singular);

  /// @param place [m]
  /// @param von_mises stress at the place [Pa]
  /// @param share see OwnFieldShare
  bool operator()(const dealii::Point<dim>& place, unsigned int body, double von_mises,
                  double share) const;

  /// By a cell's middle and its nodes' maximum.
  bool operator()(const NodalStress<dim>& stress, const StressCell<dim>& cell) const;

 private:
  ContactsOwnField<dim> own_field_;
  double length_;  ///< unit of the triangulation [m]
  const std::vector<SingularPlace<dim>>& singular_;
};

/// The maximum variation of stress over a cell of a body outside, on all ranks [Pa].
template <int dim>
double maximum_variation(const NodalStress<dim>& stress, const OutsideOfContact<dim>& is_outside,
                         unsigned int body);

/// Whether a cell is longer than half of the radius of a notch that it bounds. The stress there
/// changes over lengths like that radius, in 3-D along the notch as well: between the nodes of such
/// a cell it may have a maximum that none of them shows. What a support or a tie holds is no notch.
template <int dim>
bool may_hide_maximum(const Solution<dim>& solution, const StressCell<dim>& cell);

}  // namespace geneva::fem
