#pragma once

#include <vector>

#include "fem/contact/contact_row.h"
#include "fem/contact/overlap.h"

namespace geneva::fem {

/// Dual mortar coupling of a contact pair: one row for every source node that faces the target.
///
/// The integrals run over the true overlaps of the two meshes. The dual basis is biorthogonal on
/// the overlap itself, so that edges that stick out of the target stay exact.
///
/// The gap is that of the true surfaces. Within the contact the surfaces' relative curvature is
/// taken up by the displacements, each body's share being that of its compliance (K. L. Johnson,
/// Contact Mechanics, 1985, section 4.1); a displacement that is linear along an edge misses the
/// part u'' xi (1 - xi) h^2/2 of that, which is added to the gap. Without it the pressure of meshes
/// that do not match ripples in proportion to h.
template <int dim>
std::vector<ContactRow<dim>> mortar_rows(const Surface<dim>& source, const Surface<dim>& target,
                                         const MortarData<dim>& data);

}  // namespace geneva::fem
