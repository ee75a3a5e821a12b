#pragma once

#include <cmath>
#include <vector>

#include "fem/contact/interface.h"
#include "fem/contact/mortar.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {

/// A flat source on a flat target with nodes every 1/n.
inline ContactInterface<2> flat_pair(const unsigned int n, const double gap = 0.) {
  std::vector<double> x;
  for (unsigned int i = 0; i <= n; ++i) x.push_back(static_cast<double>(i) / n);
  ContactInterface<2> interface;
  interface.source = underside(x, gap);
  interface.target = upper_side(x);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status.assign(interface.rows.size(), NodeStatus::open);
  return interface;
}

inline constexpr NodeStatus open = NodeStatus::open;
inline constexpr NodeStatus slip = NodeStatus::slip;
using Status = std::vector<NodeStatus>;

inline ContactInterface<2> with_status(const Status& status) {
  ContactInterface<2> interface = flat_pair(static_cast<unsigned int>(status.size()) - 1);
  interface.status = status;
  return interface;
}

inline ContactInterface<2> with_active(const std::vector<bool>& active) {
  Status status;
  for (const bool touches : active) status.push_back(touches ? slip : open);
  return with_status(status);
}

/// Hertz's pressure at the nodes of a flat pair, contact from 0.5 + offset - b to 0.5 + offset + b.
inline ContactState hertz_state(ContactInterface<2>& interface, const double centre,
                                const double half_width) {
  ContactState state;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const double x = interface.source.nodes[interface.rows[i].node].position[0] - centre;
    const double square = 1. - x * x / (half_width * half_width);
    interface.status[i] = square > 0. ? slip : open;
    state.pressure.push_back(square > 0. ? std::sqrt(square) : 0.);
    state.gap.push_back(square > 0. ? 0. : -square);
    state.slip.push_back({});
    state.friction.push_back({});
  }
  return state;
}

inline ContactState without_slip(const std::vector<double>& pressure,
                                 const std::vector<double>& gap, const double approach) {
  return {pressure, gap, approach, std::vector<Tangential>(gap.size()),
          std::vector<Tangential>(gap.size())};
}

}  // namespace geneva::fem::test
