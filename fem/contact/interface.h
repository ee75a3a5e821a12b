#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "fem/contact/contact_law.h"
#include "fem/contact/contact_row.h"
#include "fem/contact/surface.h"

namespace geneva::fem {

/// From and to, of arc length on a surface.
using ArcIntervals = std::vector<std::pair<double, double>>;

/// Along the tangents of a frame; in the plane the second is 0.
using Tangential = std::array<double, 2>;

/// One contact pair on one mesh, the same on every rank.
template <int dim>
struct ContactInterface {
  Surface<dim> source;
  Surface<dim> target;
  std::vector<ContactRow<dim>> rows;
  std::vector<NodeStatus> status;  ///< by row
  double source_share = 0.5;       ///< of the source body in the compliance of both, 0..1
  ArcIntervals smooth = {};  ///< of the source, in the plane: there the edges are short enough
  dealii::Tensor<1, dim> approach = {};  ///< unit vector along which loads push the source to the
                                         ///< target; 0 if not known
  std::shared_ptr<const ContactLaw<dim>> law = std::make_shared<const Frictionless<dim>>();
  std::vector<Components<dim>> sliding = {};  ///< by row, see NodeContact; empty: not known

  std::vector<Tangential> slip_before = {};  ///< by row, at the instant before; empty: none

  /// Whether nodes may stick: friction whose sliding is not imposed.
  [[nodiscard]] bool may_stick() const { return law->touching() == NodeStatus::stick; }

  [[nodiscard]] Tangential slip_before_at(const std::size_t row) const {
    return slip_before.empty() ? Tangential{} : slip_before[row];
  }
  [[nodiscard]] Components<dim> sliding_at(const std::size_t row) const {
    return sliding.empty() ? Components<dim>{} : sliding[row];
  }
};

/// What is at the source nodes, by row.
struct ContactState {
  std::vector<double> pressure;           ///< >= 0 in compression
  std::vector<double> gap;                ///< > 0 when open
  double approach = 0.;                   ///< maximum change of a gap by the displacement
  std::vector<Tangential> slip = {};      ///< of the source against the target
  std::vector<Tangential> friction = {};  ///< traction on the source
};

/// How a node of the source moves against the target, by its place, whatever the mesh.
template <int dim>
struct NodeMotion {
  dealii::Point<dim> place;
  NodeStatus status;
  dealii::Tensor<1, dim> sliding;  ///< see NodeContact, along the axes
};

/// Which nodes of the source belong to the chosen rows.
template <int dim>
std::vector<bool> nodes_of_rows(const ContactInterface<dim>& interface,
                                const std::vector<bool>& rows) {
  std::vector<bool> chosen(interface.source.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (rows[i]) chosen[interface.rows[i].node] = true;
  return chosen;
}

}  // namespace geneva::fem
