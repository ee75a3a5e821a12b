#pragma once

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

#include "fem/outside_of_contact.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

/// What a cell may leave open of a stress at a place [Pa].
///
/// The error of a figure is the sum over the cells of the integral of (sigma - sigma_h) : (eps* -
/// eps*_h), eps* being the strain of the figure's own dual problem (Becker and Rannacher, Acta
/// Numerica 10, 2001, 3). That of a stress at a place is the field of a pair of forces there: on a
/// half-plane 2/(pi r^2), on a half-space 1/(2 pi r^3), over the modulus. A cell follows about half
/// of what varies linearly in it, and leaves amplitudes of v/2 and h/4 times the slope of eps*; the
/// mean of the product of two linear functions is a third of their amplitudes'. So a cell of the
/// size h leaves at most about
///
///   c v h V / r^(dim + 1),  c = 1/(6 pi) in the plane, 1/(16 pi) in 3-D,
///
/// where r is not less than h. A long cell counts as parts that are as long as wide: what varies
/// across it beside the place is as near as they.
/// @param variation v, from its mean, of the stress over the cell [Pa]
/// @param measure V of the cell: area or volume
/// @param size h
/// @param distance r of its middle from the place; all lengths in one unit
template <int dim>
double open_by_cell(double variation, double measure, double size, double distance);

/// What all cells of a body leave open of its maximum, and one cell whose own stress may be that,
/// relative to it; inside of a contact's own field and beside singular places, where no maximum is
/// looked for, no stress may be. Beyond a tenth of the model's extent r counts no more: there a
/// figure's own field is that of the body as a whole, and falls no farther.
template <int dim>
double open_by_cells(const Solution<dim>& solution, const NodalStress<dim>& stress,
                     const OutsideOfContact<dim>& is_outside, unsigned int body,
                     const StressMaximum<dim>& maximum);

/// Flags the cells that leave most open of their bodies' wanted maxima where these are, and those
/// whose own stress may be the maximum and is left open by more than a tenth of that.
/// @param may_be_finer whether a cell may be flagged
/// @param bulk share of all that they leave open together, between 0 and 1
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_open(const Solution<dim>& solution, const NodalStress<dim>& stress,
                       const OutsideOfContact<dim>& is_outside, const WantedMaxima<dim>& wanted,
                       const std::function<bool(const StressCell<dim>&)>& may_be_finer,
                       double bulk = 0.5);

}  // namespace geneva::fem
