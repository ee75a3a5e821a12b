#include "fem/adaptivity/error_estimate.h"
#include "fem/contact/zone.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace geneva::fem {

namespace {

/// The meshes that refined the contact zone.
std::vector<std::size_t> zone_steps(const std::vector<LevelRecord>& history) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 1; i < history.size(); ++i)
    if (history[i].refined == Refined::zone) steps.push_back(i);
  return steps;
}

/// Relative error over the square of the grading as long as it has not been measured: the maximum
/// that was seen, of cells five times as long as deep and of tilted pins in 3-D.
constexpr double maximum_grading_coefficient = 0.35;

/// Share of the peak pressure that is open because a free end of the contact lies somewhere on an
/// edge, times the square of the number of active nodes. Measured in the plane on a cylinder under
/// 52 loads, with 7 to 17 nodes: 0.04 +- 0.05 of the pressure that is freed from the nodes; and at
/// random places of the meshes, with 6 to 100 nodes, 0.22 +- 0.25 of the nodes', at most 0.83.
/// Changes from mesh to mesh hold a part of this already, so that mean and deviation are enough
/// there. In 3-D and next to an axis, which lowers the peak by up to 0.6, it is the maximum.
constexpr double coefficient_of_line_contact = 0.12;
constexpr double fewest_freed_nodes = 7.;
constexpr double coefficient_in_plane = 0.47;
constexpr double coefficient = 0.8;

bool has_free_end(const ContactInterface<2>& interface) {
  const std::vector<bool> active = closed(interface.status);
  return std::adjacent_find(active.begin(), active.end(), std::not_equal_to<>()) != active.end();
}

bool has_free_end(const ContactInterface<3>& interface) { return nodes_across(interface) > 0; }

double maximum_of(const std::vector<double>& pressures) {
  return pressures.empty() ? 0. : *std::max_element(pressures.begin(), pressures.end());
}

/// Rows [begin, end) of a contact's zone that follow each other.
struct Run {
  std::size_t begin, end;
};

std::vector<Run> runs_of(const std::vector<bool>& in_zone) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < in_zone.size(); ++i) {
    if (!in_zone[i]) continue;
    if (i == 0 || !in_zone[i - 1]) runs.push_back({i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

/// The peak of a run, and from how many nodes its pressure rises to it.
struct Rise {
  double peak;
  std::size_t nodes;  ///< from the nearer free end to the peak, both counted; 0 without a free end
};

Rise rise_of(const Run& run, const ContactInterface<2>& interface,
             const std::vector<double>& pressures) {
  const auto [begin, end] = run;
  const auto& status = interface.status;
  const auto first = pressures.begin();
  const auto peak =
      static_cast<std::size_t>(std::max_element(first + static_cast<std::ptrdiff_t>(begin),
                                                first + static_cast<std::ptrdiff_t>(end)) -
                               first);
  const bool starts_free = begin > 0 && !is_closed(status[begin - 1]);
  const bool ends_free = end < status.size() && !is_closed(status[end]);
  if (!starts_free && !ends_free) return {pressures[peak], 0};
  std::size_t nodes = end - begin;
  if (starts_free) nodes = std::min(nodes, peak - begin + 1);
  if (ends_free) nodes = std::min(nodes, end - peak);
  return {pressures[peak], nodes};
}

/// The uncertainty of each run of nodes times its maximum pressure, which a single node beyond the
/// end of a contact has little of. What counts is how many nodes the pressure has to rise from a
/// free end to its peak: half of all where it is Hertz's, few where it peaks beside the end.
double end_uncertainty(const ContactInterface<2>& interface, const std::vector<double>& pressures,
                       const EndTraits& traits) {
  double uncertainty = 0.;
  for (const Run& run : runs_of(zone_rows(interface))) {
    const Rise rise = rise_of(run, interface, pressures);
    if (rise.nodes == 0) continue;
    const auto nodes = static_cast<double>(traits.is_on_axis ? rise.nodes : 2 * rise.nodes - 1);
    const bool is_freed = traits.is_freed_from_nodes && nodes >= fewest_freed_nodes;
    const double of_end = traits.is_on_axis ? coefficient
                          : is_freed        ? coefficient_of_line_contact
                                            : coefficient_in_plane;
    uncertainty = std::max(uncertainty, of_end * rise.peak / (nodes * nodes));
  }
  return uncertainty;
}

double end_uncertainty(const ContactInterface<3>& interface, const std::vector<double>& pressures,
                       const EndTraits& /*traits*/) {
  const double nodes = nodes_across(interface);
  return nodes > 0. ? coefficient * maximum_of(pressures) / (nodes * nodes) : 0.;
}

/// A change of a figure from one mesh to the next, relative to the newest value.
struct Change {
  double size;
  unsigned int halvings;
};

/// Changes over the meshes that refined one of the two, the newest last.
std::vector<Change> changes(const std::vector<MeshValue>& values, const Refined refined) {
  std::vector<Change> result;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i].refined == refined)
      result.push_back(
          {(values[i].value - values[i - 1].value) / values.back().value, values[i].halvings});
  return result;
}

/// Share of a change over so many halvings that is still to come, at an order of convergence.
double still_to_come(const unsigned int halvings, const double order) {
  return 1. / (std::pow(2., order * halvings) - 1.);
}

/// Ratio of two successive changes at an order of convergence.
double ratio_at(const double order, const Change& before, const Change& now) {
  return std::pow(2., order * now.halvings) * still_to_come(now.halvings, order) /
         still_to_come(before.halvings, order);
}

/// Between 1 and 2, the order that two successive changes show; 1 where they differ in sign and
/// show none.
double order_of(const Change& before, const Change& now) {
  if (before.size * now.size < 0.) return 1.;
  const double ratio = std::log(std::abs(before.size) / std::max(std::abs(now.size), 1e-300));
  const double first = std::log(ratio_at(1., before, now));
  const double second = std::log(ratio_at(2., before, now));
  return std::clamp(1. + (ratio - first) / (second - first), 1., 2.);
}

/// Share of what Richardson's rule leaves that stays in the estimate of the peak in the plane: all
/// of it is too much, see doc/theory.md, 5.2. Changes that differ in sign show the scatter of the
/// ends, if they are not freed from it, and all stays. So it does in 3-D, where there are fewer
/// meshes, and of other figures.
double share_that_stays(const Convergence& convergence, const bool shows_order) {
  if (convergence.is_freed_from_nodes) return 0.2;
  return convergence.is_peak_in_plane && shows_order ? 0.7 : 1.;
}

double zone_error(const std::vector<Change>& changes, const Convergence& convergence) {
  if (changes.empty()) return 1.;
  const Change& now = changes.back();
  if (changes.size() == 1) return std::abs(now.size) * still_to_come(now.halvings, 1.);
  const Change& before = changes[changes.size() - 2];
  const double left_of_before =
      std::abs(before.size) * still_to_come(before.halvings, 2.) / std::pow(4., now.halvings);
  const double left = std::max(
      std::abs(now.size) * still_to_come(now.halvings, order_of(before, now)), left_of_before);
  return share_that_stays(convergence, before.size * now.size > 0.) * left;
}

/// A smaller fall of the size measure would make more than twice the change of it.
constexpr double minimum_ratio = 1.5;

/// By how much halved cells lower their part of the error, however far the measure falls: an error
/// of second order to a quarter at best. Where a displacement is given, the stiffness of the bodies
/// decides how great the force is, and its error falls as the energy's does: by half where a
/// support ends on a straight side, where the displacement goes with the root of the distance
/// (Williams 1952). Where the energy's error is known, other parts fall as much as that.
double maximum_ratio(const MeshValue& before, const MeshValue& now,
                     const Convergence& convergence) {
  const double most = convergence.forces_are_given ? 4. : 2.;
  if (!(now.energy_error > 0.)) return most;
  return std::clamp(before.energy_error / now.energy_error, minimum_ratio, most);
}

/// What the cells around a contact leave, from what their size measure promises and, times the
/// square of the grading, from what others have shown.
struct LeftAround {
  double taken, doubt;        ///< shares of what the measure promises
  double known, least_doubt;  ///< over the square of the grading
};

/// Measured on random line contacts and wheels under given loads, see doc/theory.md, 5.2. Where the
/// force depends on the cells, what is left lies between nothing and all. Where the pressure peaks
/// beside an end, the fields are not those that the measure is made for.
LeftAround left_around_of(const Convergence& convergence) {
  if (convergence.peaks_beside_end) return {0.5, 1., 0., 0.};
  if (!convergence.forces_are_given) return {0.5, 0.5, 0., 0.};
  if (!convergence.is_freed_from_nodes) return {0.75, 0.3, 0., 0.};
  const double nu = convergence.poissons_ratio;
  return {0.4, 0.2, -0.011 - 0.055 * nu * nu, 0.012};
}

}  // namespace

template <int dim>
double first_grading(const double accuracy) {
  // After one step half of the correction is then about a tenth of the accuracy on compact cells,
  // where the error is 0.035 times the square of the grading at most. With more than half, two
  // neighbours would have to differ by more than two in size.
  constexpr double maximum = dim == 2 ? 0.5 : 0.42;
  return std::min(maximum, std::sqrt(25. * accuracy));
}

template <int dim>
bool shows_zone_error(const std::vector<LevelRecord>& history) {
  if (history.back().nodes_across < fewest_active_nodes) return false;
  const auto steps = zone_steps(history);
  return dim == 3 || std::any_of(steps.begin(), steps.end(), [&](const std::size_t i) {
           return std::min(history[i - 1].nodes_across, history[i].nodes_across) >=
                  fewest_active_nodes;
         });
}

std::vector<MeshValue> resolved_values(const std::vector<LevelRecord>& history,
                                       double LevelRecord::*pressure, const ForcePower& force) {
  std::vector<MeshValue> values;
  for (const LevelRecord& level : history) {
    if (level.nodes_across < nodes_for_grading)
      values.clear();
    else if (level.*pressure > 0.)
      values.push_back({under_true_force(level.*pressure, level.energy_error, force), level.refined,
                        level.halvings, level.size_measure, level.energy_error});
  }
  return values;
}

Extrapolation extrapolate(const std::vector<MeshValue>& values, const double grading,
                          const Convergence& convergence) {
  const LeftAround left_around = left_around_of(convergence);
  const auto zone_changes = changes(values, Refined::zone);
  Extrapolation result{0., std::min(1., zone_error(zone_changes, convergence)),
                       std::min(1., maximum_grading_coefficient * grading * grading)};
  const bool zone_has_sign = convergence.is_on_axis && convergence.forces_are_given;
  if (zone_has_sign && zone_changes.size() > 1)
    result.correction = zone_changes.back().size * still_to_come(zone_changes.back().halvings, 2.);
  double of_surroundings = 0.;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double ratio = values[i - 1].size_measure / values[i].size_measure;
    if (values[i].refined != Refined::surroundings || !(ratio >= minimum_ratio)) continue;
    const double most = maximum_ratio(values[i - 1], values[i], convergence);
    const double left = (1. - values[i - 1].value / values[i].value) / (std::min(ratio, most) - 1.);
    of_surroundings = left_around.taken * left + left_around.known * grading * grading;
    result.surroundings_error =
        std::max(left_around.doubt * std::abs(left), left_around.least_doubt * grading * grading);
  }
  result.correction += of_surroundings;
  return result;
}

double error_of(const double one, const double other) {
  return std::min(1., std::hypot(one, other));
}

template <int dim>
double end_error(const std::vector<ContactInterface<dim>>& interfaces,
                 const std::vector<ContactState>& states, const EndTraits& traits) {
  double maximum = 0.;
  double error = 0.;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    maximum = std::max(maximum, maximum_of(states[i].pressure));
    error = std::max(error, end_uncertainty(interfaces[i], states[i].pressure, traits));
  }
  return maximum > 0. ? error / maximum : 0.;
}

template <>
bool peaks_beside_end(const std::vector<ContactInterface<2>>& interfaces,
                      const std::vector<ContactState>& states) {
  double maximum = 0.;
  bool is_beside_end = false;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
    for (const Run& run : runs_of(closed(interfaces[i].status))) {
      const Rise rise = rise_of(run, interfaces[i], states[i].pressure);
      if (rise.peak <= maximum) continue;
      maximum = rise.peak;
      is_beside_end = 0 < rise.nodes && 3 * rise.nodes < run.end - run.begin;
    }
  return is_beside_end;
}

template <>
bool peaks_beside_end(const std::vector<ContactInterface<3>>& /*interfaces*/,
                      const std::vector<ContactState>& /*states*/) {
  return false;
}

template <int dim>
bool has_free_ends(const std::vector<ContactInterface<dim>>& interfaces) {
  return std::any_of(interfaces.begin(), interfaces.end(),
                     [](const auto& interface) { return has_free_end(interface); });
}

bool grows_without_bound(const std::vector<LevelRecord>& history) {
  // Halving the edges beside a square edge on a half-plane raises the pressure by 17 %, under a
  // rigid one by 41 %; a bounded pressure changes by a few per cent once the contact has this many
  // nodes.
  constexpr std::size_t meshes = 4;
  constexpr unsigned int resolved_nodes = 16;
  constexpr double growth = 1.1;
  const auto steps = zone_steps(history);
  if (steps.size() < meshes - 1) return false;
  return std::all_of(steps.end() - (meshes - 1), steps.end(), [&](const std::size_t i) {
    return history[i - 1].nodes_across >= resolved_nodes &&
           history[i].peak_pressure >= growth * history[i - 1].peak_pressure;
  });
}

bool stands_still(const std::vector<LevelRecord>& history) {
  constexpr std::ptrdiff_t meshes = 3;
  constexpr double same = 0.01;
  const auto steps = zone_steps(history);
  if (static_cast<std::ptrdiff_t>(steps.size()) < meshes) return false;
  return std::all_of(steps.end() - meshes, steps.end(), [&](const std::size_t i) {
    return history[i].active_nodes <= history[i - 1].active_nodes &&
           std::abs(history[i].peak_pressure - history[i - 1].peak_pressure) <
               same * history[i].peak_pressure;
  });
}

EdgePressure edge_pressure(const std::vector<LevelRecord>& history) {
  // A square edge on a half-space of the same material has gamma = 0.226 (Dundurs and Lee 1972), a
  // rigid one 0.5; cells longer than the contact is wide show less of it. Where the edge is broken,
  // the contact ends before it, and where both bodies end together, the pressure is less there.
  constexpr double minimum_exponent = 0.03;
  EdgePressure edge{true, 0., history.back().end_pressure};
  const auto steps = zone_steps(history);
  if (steps.empty()) return edge;
  const LevelRecord& now = history[steps.back()];
  const LevelRecord& before = history[steps.back() - 1];
  if (now.end_pressure <= 0. || before.end_pressure <= 0.) return edge;
  edge.growth_exponent = std::log2(now.end_pressure / before.end_pressure) / now.halvings;
  const bool leads = now.end_pressure >= now.peak_pressure * (1. - 1e-12);
  edge.is_bounded = !(leads && now.mid_length_pressure < now.peak_pressure &&
                      edge.growth_exponent > minimum_exponent);
  return edge;
}

template bool shows_zone_error<2>(const std::vector<LevelRecord>&);
template bool shows_zone_error<3>(const std::vector<LevelRecord>&);
template double first_grading<2>(double);
template double first_grading<3>(double);
template double end_error(const std::vector<ContactInterface<2>>&, const std::vector<ContactState>&,
                          const EndTraits&);
template double end_error(const std::vector<ContactInterface<3>>&, const std::vector<ContactState>&,
                          const EndTraits&);
template bool has_free_ends(const std::vector<ContactInterface<2>>&);
template bool has_free_ends(const std::vector<ContactInterface<3>>&);

}  // namespace geneva::fem
