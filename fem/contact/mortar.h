#pragma once

#include <utility>
#include <vector>

#include "fem/contact/overlap.h"

namespace geneva::fem {

/// The weighted gap of one source node as a linear function of the displacements (Popp, Gee and
/// Wall 2009, Eq. 14): gap_j(u) = initial_gap + normal . (D u_j) - sum_k coupling_jk . u_k.
template <int dim>
struct MortarRow {
  unsigned int node = 0;  ///< of the source surface
  double weight = 0.;  ///< D_j = integral of N_j over the overlap, times the out-of-plane measure
  dealii::Tensor<1, dim>
      normal;  ///< target's outward normal, averaged with the dual basis function of the node
  double initial_gap = 0.;  ///< integral of psi_j times the initial gap; positive when open
  std::vector<std::pair<unsigned int, dealii::Tensor<1, dim>>>
      coupling;  ///< (target node, integral of psi_j N_k n)
};

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
std::vector<MortarRow<dim>> mortar_rows(const Surface<dim>& source, const Surface<dim>& target,
                                        const MortarData<dim>& data);

}  // namespace geneva::fem
