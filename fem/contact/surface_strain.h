#pragma once

#include <vector>

#include "fem/contact/contact_result.h"
#include "fem/contact/interface.h"
#include "fem/discretisation/vector.h"

namespace geneva::fem {

/// Strains along both surfaces of a pair in the plane, by row: t . du/ds with the tangent t, of the
/// source's nodes and of the target's displacement sum_k M_jk u_k / D_j that each of them meets.
/// The derivative is that of the parabola through a node and its neighbours, of the first order at
/// the ends of the surface. Recovered stresses of cells are worse where the surface slides: the
/// stress along it has a cusp at the end of the contact.
/// @param displacement with the boundary's values on this rank
std::vector<SurfaceStrain> surface_strains(const ContactInterface<2>& interface,
                                           const Vector& displacement);

}  // namespace geneva::fem
