#include "fem/holding_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "fem/contact/active_set.h"

namespace geneva::fem {

namespace {

/// A place in the sets.
struct PlaceInSets {
  std::size_t interface;
  std::size_t row;
};

/// How near a node in contact is to sticking; less is nearer.
struct Nearness {
  bool has_slipped;  ///< those that stuck come first
  double rank;  ///< of those their friction over their pressure; of the others minus the pressure

  bool operator<(const Nearness& other) const {
    return std::tie(has_slipped, rank) < std::tie(other.has_slipped, other.rank);
  }
};

Nearness nearness(const NodeStatus status, const ContactState& state, const std::size_t row) {
  const double pressure = std::max(state.pressure[row], std::numeric_limits<double>::min());
  if (status != NodeStatus::stick) return {true, -pressure};
  return {false, std::hypot(state.friction[row][0], state.friction[row][1]) / pressure};
}

/// Of the nodes in contact that some interfaces have, the one that is nearest to sticking. Nothing
/// if one sticks, or none touches.
template <int dim>
std::optional<PlaceInSets> nearest_to_sticking(const Level<dim>& level,
                                               const std::vector<ContactState>& states,
                                               const ActiveSets& next,
                                               const std::vector<std::size_t>& interfaces) {
  std::optional<PlaceInSets> nearest;
  Nearness least{};
  for (const std::size_t i : interfaces)
    for (std::size_t row = 0; row < next[i].size(); ++row) {
      if (next[i][row] == NodeStatus::stick) return std::nullopt;
      if (!is_closed(next[i][row])) continue;
      const Nearness now = nearness(level.interfaces[i].status[row], states[i], row);
      if (nearest && !(now < least)) continue;
      least = now;
      nearest = {i, row};
    }
  return nearest;
}

/// The direction in which a node slides that stuck and is to slip, against the friction on it.
template <int dim>
dealii::Tensor<1, dim> released_direction(const Level<dim>& level,
                                          const std::vector<ContactState>& states,
                                          const PlaceInSets& place) {
  dealii::Tensor<1, dim> direction;
  const auto& tangents = level.interfaces[place.interface].rows[place.row].frame.tangents;
  for (std::size_t t = 0; t < tangents.size(); ++t)
    direction -= states[place.interface].friction[place.row][t] * tangents[t];
  return direction;
}

/// Of the nodes that slip backwards, the one that has slipped least: the first to turn where the
/// body moves on.
template <int dim>
std::optional<PlaceInSets> first_to_turn(const Level<dim>& level,
                                         const std::vector<ContactState>& states,
                                         const std::vector<std::size_t>& interfaces,
                                         const dealii::Tensor<1, dim>& forwards) {
  std::optional<PlaceInSets> first;
  double least = std::numeric_limits<double>::max();
  for (const std::size_t i : interfaces) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    for (std::size_t row = 0; row < interface.rows.size(); ++row) {
      if (interface.status[row] != NodeStatus::slip) continue;
      double speed = 0.;
      double slip = 0.;
      for (std::size_t t = 0; t + 1 < dim; ++t) {
        const double since = states[i].slip[row][t] - interface.slip_before_at(row)[t];
        speed +=
            interface.sliding_at(row)[t + 1] * (forwards * interface.rows[row].frame.tangents[t]);
        slip += since * since;
      }
      if (speed >= 0. || slip >= least) continue;
      least = slip;
      first = {i, row};
    }
  }
  return first;
}

template <int dim>
std::size_t n_sticking(const Level<dim>& level, const std::vector<std::size_t>& interfaces) {
  std::size_t sticking = 0;
  for (const std::size_t i : interfaces)
    sticking += static_cast<std::size_t>(std::count(
        level.interfaces[i].status.begin(), level.interfaces[i].status.end(), NodeStatus::stick));
  return sticking;
}

/// The closed row with the greatest pressure; nothing if all are open.
template <int dim>
std::optional<std::size_t> most_pressed(const ContactInterface<dim>& interface,
                                        const ContactState& state) {
  std::optional<std::size_t> greatest;
  for (std::size_t row = 0; row < interface.status.size(); ++row)
    if (is_closed(interface.status[row]) &&
        (!greatest || state.pressure[row] > state.pressure[*greatest]))
      greatest = row;
  return greatest;
}

}  // namespace

template <int dim>
bool keep_one_stuck(const Level<dim>& level, const std::vector<ContactState>& states,
                    ActiveSets& next) {
  bool is_kept = false;
  const auto keep_in = [&](const std::vector<std::size_t>& interfaces) {
    auto stuck = nearest_to_sticking(level, states, next, interfaces);
    if (!stuck) return;
    if (n_sticking(level, interfaces) == 1) {
      const auto turning =
          first_to_turn(level, states, interfaces, released_direction(level, states, *stuck));
      if (turning) {
        next[turning->interface][turning->row] = NodeStatus::stick;
        return;
      }
    }
    next[stuck->interface][stuck->row] = NodeStatus::stick;
    is_kept = true;
  };
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (!level.interfaces[i].may_stick()) continue;
    all.push_back(i);
    if (level.holds_by_friction[i]) keep_in({i});
  }
  keep_in(all);
  return is_kept;
}

template <int dim>
bool keep_one_closed(const Level<dim>& level, const std::vector<ContactState>& states,
                     ActiveSets& next) {
  bool is_kept = false;
  for (std::size_t i = 0; i < next.size(); ++i) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    if (!level.holds_by_contact[i] || std::any_of(next[i].begin(), next[i].end(), is_closed))
      continue;
    const auto left = most_pressed(interface, states[i]);
    if (!left) continue;
    if (const auto ahead = first_ahead(interface, states[i], interface.rows[*left].frame.normal)) {
      next[i][*ahead] = interface.law->touching();
      continue;
    }
    next[i][*left] = interface.status[*left];
    is_kept = true;
  }
  return is_kept;
}

template bool keep_one_stuck(const Level<2>&, const std::vector<ContactState>&, ActiveSets&);
template bool keep_one_stuck(const Level<3>&, const std::vector<ContactState>&, ActiveSets&);
template bool keep_one_closed(const Level<2>&, const std::vector<ContactState>&, ActiveSets&);
template bool keep_one_closed(const Level<3>&, const std::vector<ContactState>&, ActiveSets&);

}  // namespace geneva::fem
