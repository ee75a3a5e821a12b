#include "fem/contact/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geneva::fem {

namespace {

/// Pressures below this share of the greatest one, and overlaps below this share of the approach,
/// are round-off, not a reason to change the active set.
constexpr double round_off = 1e-9;

double initial_gap(const MortarRow& row) { return row.initial_gap / row.weight; }

/// The component to solve a row for; none if all are held.
int pivot_component(const MortarRow& row, const SurfaceNode& node,
                    const std::set<global_dof_index>& held) {
  int pivot = -1;
  for (unsigned int component = 0; component < 2; ++component) {
    const double share = std::abs(row.normal[component]);
    if (held.count(node.dofs[component]) == 0 && share > 1e-6 &&
        (pivot < 0 || share > std::abs(row.normal[static_cast<unsigned int>(pivot)])))
      pivot = static_cast<int>(component);
  }
  return pivot;
}

ConstraintLine contact_line(const ContactInterface& interface, const MortarRow& row,
                            const unsigned int pivot) {
  const SurfaceNode& node = interface.source.nodes[row.node];
  const double diagonal = row.weight * row.normal[pivot];
  ConstraintLine line{node.dofs[pivot], {}, -row.initial_gap / diagonal};
  const unsigned int other = 1 - pivot;
  if (row.normal[other] != 0.)
    line.entries.emplace_back(node.dofs[other], -row.normal[other] / row.normal[pivot]);
  for (const auto& [target_node, coupling] : row.coupling)
    for (unsigned int component = 0; component < 2; ++component)
      if (coupling[component] != 0.)
        line.entries.emplace_back(interface.target.nodes[target_node].dofs[component],
                                  coupling[component] / diagonal);
  return line;
}

double gap_of(const ContactInterface& interface, const MortarRow& row,
              const dealii::TrilinosWrappers::MPI::Vector& displacement) {
  const SurfaceNode& node = interface.source.nodes[row.node];
  double gap = row.initial_gap;
  for (unsigned int component = 0; component < 2; ++component) {
    gap += row.weight * row.normal[component] * displacement(node.dofs[component]);
    for (const auto& [target_node, coupling] : row.coupling)
      gap -=
          coupling[component] * displacement(interface.target.nodes[target_node].dofs[component]);
  }
  return gap / row.weight;
}

double pressure_of(const SurfaceNode& node, const MortarRow& row,
                   const dealii::TrilinosWrappers::MPI::Vector& residual,
                   const std::set<global_dof_index>& held) {
  double force = 0.;
  double normal_square = 0.;
  for (unsigned int component = 0; component < 2; ++component) {
    if (held.count(node.dofs[component]) > 0) continue;
    force += residual(node.dofs[component]) * row.normal[component];
    normal_square += row.normal[component] * row.normal[component];
  }
  return normal_square > 0. ? force / (row.weight * normal_square) : 0.;
}

}  // namespace

std::vector<bool> first_touch(const std::vector<MortarRow>& rows, const double length) {
  double smallest = std::numeric_limits<double>::max();
  for (const MortarRow& row : rows) smallest = std::min(smallest, initial_gap(row));
  std::vector<bool> active;
  active.reserve(rows.size());
  for (const MortarRow& row : rows) active.push_back(initial_gap(row) <= smallest + 1e-9 * length);
  return active;
}

std::vector<bool> inherited(const ContactInterface& interface,
                            const std::vector<ContactInterval>& intervals, const double length) {
  const double slack = 1e-9 * interface.source.length;
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (const MortarRow& row : interface.rows) {
    const double at = interface.source.nodes[row.node].arc_length;
    active.push_back(
        std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& interval) {
          return at >= interval.begin / length - slack && at <= interval.end / length + slack;
        }));
  }
  if (std::none_of(active.begin(), active.end(), [](const bool is_active) { return is_active; }))
    return first_touch(interface.rows, interface.source.length);
  return active;
}

std::vector<std::pair<double, double>> active_intervals(const ContactInterface& interface) {
  std::vector<bool> node_active(interface.source.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (interface.active[i]) node_active[interface.rows[i].node] = true;
  std::vector<std::pair<double, double>> intervals;
  bool open = false;
  for (std::size_t i = 0; i < node_active.size(); ++i) {
    const double at = interface.source.nodes[i].arc_length;
    if (node_active[i] && open) intervals.back().second = at;
    if (node_active[i] && !open) intervals.emplace_back(at, at);
    open = node_active[i];
  }
  return intervals;
}

std::vector<ConstraintLine> contact_lines(const ContactInterface& interface,
                                          std::set<global_dof_index>& held) {
  std::vector<ConstraintLine> lines;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    if (!interface.active[i]) continue;
    const MortarRow& row = interface.rows[i];
    const int pivot = pivot_component(row, interface.source.nodes[row.node], held);
    if (pivot < 0) continue;
    lines.push_back(contact_line(interface, row, static_cast<unsigned int>(pivot)));
  }
  for (const ConstraintLine& line : lines) held.insert(line.dof);
  return lines;
}

ContactState evaluate(const ContactInterface& interface,
                      const dealii::TrilinosWrappers::MPI::Vector& displacement,
                      const dealii::TrilinosWrappers::MPI::Vector& residual,
                      const std::set<global_dof_index>& held) {
  ContactState state;
  for (const MortarRow& row : interface.rows) {
    state.gap.push_back(gap_of(interface, row, displacement));
    state.approach = std::max(state.approach, std::abs(state.gap.back() - initial_gap(row)));
    state.pressure.push_back(pressure_of(interface.source.nodes[row.node], row, residual, held));
  }
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (!interface.active[i]) state.pressure[i] = 0.;
  return state;
}

std::vector<bool> updated(const ContactInterface& interface, const ContactState& state) {
  double greatest_pressure = 0.;
  for (const double pressure : state.pressure)
    greatest_pressure = std::max(greatest_pressure, std::abs(pressure));
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    active.push_back(interface.active[i] ? state.pressure[i] >= -round_off * greatest_pressure
                                         : state.gap[i] < -round_off * state.approach);
  return active;
}

}  // namespace geneva::fem
