#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "fem/contact/surface.h"

namespace geneva::fem {

/// The weighted gap of one source node as a linear function of the displacements (Popp, Gee and
/// Wall 2009, Eq. 14): gap_j(u) = initial_gap + normal . (D u_j) - sum_k coupling_jk . u_k.
struct MortarRow {
  unsigned int node = 0;  ///< of the source surface
  double weight = 0.;  ///< D_j = integral of N_j over the overlap, times the out-of-plane measure
  dealii::Tensor<1, 2>
      normal;  ///< target's outward normal, averaged with the dual basis function of the node
  double initial_gap = 0.;  ///< integral of psi_j times the initial gap; positive when open
  std::vector<std::pair<unsigned int, dealii::Tensor<1, 2>>>
      coupling;  ///< (target node, integral of psi_j N_k n)
};

/// What the integrals along a contact pair need beside its two surfaces.
struct MortarData {
  std::function<double(const dealii::Point<2>&)> measure;  ///< out-of-plane measure at a point
  double source_share;  ///< of the source body in the compliance of both, 0..1
};

/// Dual mortar coupling of a contact pair: one row for every source node that faces the target.
///
/// The integrals run over the true overlaps of the two meshes: every source edge is split where
/// target nodes project on it. The dual basis is biorthogonal on the overlap itself, so that edges
/// that stick out of the target stay exact.
///
/// The gap is that of the true surfaces. Within the contact the surfaces' relative curvature is
/// taken up by the displacements, each body's share being that of its compliance (K. L. Johnson,
/// Contact Mechanics, 1985, section 4.1); a displacement that is linear along an edge misses the
/// part u'' xi (1 - xi) h^2/2 of that, which is added to the gap. Without it the pressure of meshes
/// that do not match ripples in proportion to h.
std::vector<MortarRow> mortar_rows(const Surface& source, const Surface& target,
                                   const MortarData& data);

}  // namespace geneva::fem
