#include "fem/error_estimate.h"

#include <algorithm>
#include <cmath>

namespace geneva::fem {

namespace {

/// Contact zones with fewer active nodes say nothing about the pressure yet.
constexpr unsigned int fewest_nodes = 6;
/// Error of the peak pressure over the square of the grading. Measured on three wheels and three
/// line contacts with gradings of 0.18, 0.25 and 0.35: 0.03 to 0.05.
constexpr double grading_coefficient = 0.04;

/// Share of the peak pressure that is open because a free end of the contact lies somewhere on an
/// edge, times the square of the number of active nodes. Measured on unsymmetric meshes with 7 to
/// 35 nodes: 0.9 to 1.2.
constexpr double coefficient = 1.2;

double end_uncertainty(const ContactInterface<2>& interface) {
  double uncertainty = 0.;
  const auto& active = interface.active;
  for (std::size_t begin = 0; begin < active.size(); ++begin) {
    if (!active[begin] || (begin > 0 && active[begin - 1])) continue;
    std::size_t end = begin;
    while (end < active.size() && active[end]) ++end;
    const bool starts_free = begin > 0;
    const bool ends_free = end < active.size();
    if (!starts_free && !ends_free) continue;
    // A contact with one free end is half of one: the other end is a plane or axis of symmetry.
    const double nodes = static_cast<double>(end - begin) * (starts_free && ends_free ? 1. : 2.);
    uncertainty = std::max(uncertainty, coefficient / (nodes * nodes));
  }
  return uncertainty;
}

double end_uncertainty(const ContactInterface<3>& interface) {
  const double nodes = nodes_across(interface);
  return coefficient / (nodes * nodes);
}

}  // namespace

double grading_for(const double accuracy) {
  return std::min(0.3, std::sqrt(0.25 * accuracy / grading_coefficient));
}

template <int dim>
double error_estimate(const double change, const double previous_error, const double grading,
                      const std::vector<ContactInterface<dim>>& interfaces) {
  unsigned int across = 0;
  double ends = 0.;
  for (const ContactInterface<dim>& interface : interfaces) {
    across += nodes_across(interface);
    ends = std::max(ends, end_uncertainty(interface));
  }
  if (across < fewest_nodes) return 1.;
  if (ends == 0.) return std::min(1., std::max(change, previous_error));
  return std::min(
      1., std::max({change, previous_error, ends}) + grading_coefficient * grading * grading);
}

bool grows_without_bound(const std::vector<LevelRecord>& history) {
  // Halving the edges beside a square edge on a half-plane raises the pressure by 17 %, under a
  // rigid one by 41 %; a bounded pressure changes by a few per cent once the contact has this many
  // nodes.
  constexpr std::size_t meshes = 4;
  constexpr unsigned int resolved_nodes = 16;
  constexpr double growth = 1.1;
  if (history.size() < meshes) return false;
  for (std::size_t i = history.size() - meshes + 1; i < history.size(); ++i)
    if (history[i - 1].nodes_across < resolved_nodes ||
        history[i].peak_pressure < growth * history[i - 1].peak_pressure)
      return false;
  return true;
}

EdgePressure edge_pressure(const std::vector<LevelRecord>& history) {
  // A square edge on a half-space of the same material has gamma = 0.226 (Dundurs and Lee 1972), a
  // rigid one 0.5; cells longer than the contact is wide show less of it. Where the edge is broken,
  // the contact ends before it, and where both bodies end together, the pressure is less there.
  constexpr double least_exponent = 0.03;
  const LevelRecord& now = history.back();
  EdgePressure edge{true, 0., now.end_pressure};
  if (history.size() < 2) return edge;
  const LevelRecord& before = history[history.size() - 2];
  if (now.end_pressure <= 0. || before.end_pressure <= 0.) return edge;
  edge.growth_exponent = std::log2(now.end_pressure / before.end_pressure) / now.halvings;
  const bool leads = now.end_pressure >= now.peak_pressure * (1. - 1e-12);
  edge.is_bounded = !(leads && now.mid_length_pressure < now.peak_pressure &&
                      edge.growth_exponent > least_exponent);
  return edge;
}

template double error_estimate(double, double, double, const std::vector<ContactInterface<2>>&);
template double error_estimate(double, double, double, const std::vector<ContactInterface<3>>&);

}  // namespace geneva::fem
