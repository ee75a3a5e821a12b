#pragma once

#include "fem/stress_recovery.h"

namespace geneva::fem {

/// Energy of the difference between recovered and computed stresses over that of the computed ones,
/// the sums over all bodies of integrals of s : C^-1 : s (O. C. Zienkiewicz and J. Z. Zhu, Int. J.
/// Numer. Meth. Engng 24, 1987).
///
/// Where a prescribed displacement alone presses, the error of the energy is that of its work, so
/// that the force is too great by this share, in a contact of spheres, where the force goes with
/// the power 3/2 of the approach, by 6/5 of it.
/// @param displacement ghosted
/// @param stress recovered on the same mesh
/// @return >= 0; 0 without any stress
template <int dim>
double energy_error(const dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                    const Problem<dim>& problem, const NodalStress<dim>& stress);

}  // namespace geneva::fem
