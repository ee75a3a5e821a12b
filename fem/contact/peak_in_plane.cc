#include "fem/contact/peak_in_plane.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <optional>

#include "fem/contact/free_end.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

using Nodes = std::vector<ContactNode<2>>;

Nodes::const_iterator top_of(const Nodes& nodes) {
  return std::max_element(nodes.begin(), nodes.end(), [](const auto& one, const auto& other) {
    return one.pressure < other.pressure;
  });
}

/// Nodes [begin, end) around the top one that follow each other.
struct Stretch {
  Nodes::const_iterator begin, end;

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

template <typename Belongs>
Stretch stretch_around(const Nodes& nodes, const Nodes::const_iterator top,
                       const Belongs& belongs) {
  return {std::find_if_not(std::make_reverse_iterator(top), nodes.rend(), belongs).base(),
          std::find_if_not(top, nodes.end(), belongs)};
}

/// The top and as many nodes on either side, or nothing if fewer are closed.
Stretch neighbours_of(const Nodes& nodes, const Nodes::const_iterator top,
                      const std::ptrdiff_t on_either_side) {
  if (top - nodes.begin() < on_either_side || nodes.end() - top <= on_either_side)
    return {top, top};
  const Stretch around{top - on_either_side, top + on_either_side + 1};
  const bool are_closed = std::all_of(
      around.begin, around.end, [](const ContactNode<2>& node) { return is_closed(node.status); });
  return are_closed ? around : Stretch{top, top};
}

/// Least-squares fit of c0 + c1 x + c2 x^2 (c1 = 0: even) to samples (x, value, weight), the x
/// scaled to about 1.
Eigen::Vector3d weighted_parabola(const std::vector<std::array<double, 3>>& samples,
                                  const bool is_even) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(samples.size()), is_even ? 2 : 3);
  Eigen::VectorXd values(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const auto& [x, value, weight] = samples[static_cast<std::size_t>(i)];
    const double root = std::sqrt(weight);
    if (is_even)
      matrix.row(i) << root, root * x * x;
    else
      matrix.row(i) << root, root * x, root * x * x;
    values(i) = root * value;
  }
  const Eigen::VectorXd c = mesh::least_squares(matrix, values);
  return is_even ? Eigen::Vector3d(c(0), 0., c(1)) : Eigen::Vector3d(c(0), c(1), c(2));
}

/// Half of the interval that holds a parabola's value about the middle of its samples with a
/// probability of 95 %: Student's quantile times the standard error.
double confidence(const std::vector<std::array<double, 3>>& samples, const Eigen::Vector3d& c) {
  double squares = 0.;
  double weights = 0.;
  for (const auto& [x, value, weight] : samples) {
    squares += weight * std::pow(value - c(0) - x * (c(1) + x * c(2)), 2);
    weights += weight;
  }
  constexpr double coefficients = 3.;
  const double freedom = static_cast<double>(samples.size()) - coefficients;
  const boost::math::students_t student(freedom);
  return boost::math::quantile(student, 0.975) * std::sqrt(squares / weights / freedom);
}

/// The maximum node, and what its neighbours show of the curvature; nothing at an end of the
/// surface, where the pressure may have no bound.
FittedPeak maximum_node(const Nodes& nodes, const Nodes::const_iterator top) {
  if (top == nodes.begin() || top + 1 == nodes.end()) return {top->pressure, 0., 0.};
  const double drop = 2. * top->pressure - (top - 1)->pressure - (top + 1)->pressure;
  return {top->pressure, drop / (12. * top->pressure), 0.};
}

/// Active nodes that follow each other, and the one with the maximum pressure.
struct ActiveRun {
  std::size_t first, last, top;

  [[nodiscard]] std::size_t before_top() const { return top - first + 1; }
  [[nodiscard]] std::size_t after_top() const { return last - top + 1; }
  [[nodiscard]] std::size_t size() const { return last - first + 1; }
};

std::optional<ActiveRun> run_with_peak(const Nodes& nodes) {
  const auto top = top_of(nodes);
  if (top == nodes.end() || top->pressure <= 0.) return std::nullopt;
  const Stretch active =
      stretch_around(nodes, top, [](const auto& node) { return is_closed(node.status); });
  return ActiveRun{static_cast<std::size_t>(active.begin - nodes.begin()),
                   static_cast<std::size_t>(active.end - nodes.begin()) - 1,
                   static_cast<std::size_t>(top - nodes.begin())};
}

/// Active nodes whose pressure is like Hertz's.
struct HertzianRun {
  ActiveRun nodes;
  bool starts_free, ends_free;
  bool has_image;  ///< beyond an end that is not free
};

/// Where the pressure peaks about the middle of the contact or of its mirror image.
std::optional<HertzianRun> hertzian_run(const ContactResult<2>& contact) {
  const auto run = run_with_peak(contact.nodes);
  if (!run) return std::nullopt;
  const bool starts_free = run->first > 0;
  const bool ends_free = run->last + 1 < contact.nodes.size();
  const bool has_image = contact.symmetric && starts_free != ends_free;
  if (!has_image && !(starts_free && ends_free)) return std::nullopt;
  const std::size_t before = run->before_top(), after = run->after_top();
  const std::size_t nearest = !starts_free ? after : !ends_free ? before : std::min(before, after);
  if (3 * nearest < (has_image ? 2 : 1) * run->size()) return std::nullopt;
  return HertzianRun{*run, starts_free, ends_free, has_image};
}

/// (d/h)^2/N^2 of an end, N nodes from it to the peak and back, and by how much it changes if the
/// end is where the parabola has it. Without one the end falls as Hertz's, K = p0 (2/a)^(1/2).
EndShare share_of_end(const std::optional<FreeEnd>& end, const double pressure_over_peak,
                      const std::size_t nodes_to_top) {
  const double count = 2. * static_cast<double>(nodes_to_top) - 1.;
  if (!end) {
    const double shift = shift_by_last_node(0.5 * pressure_over_peak * std::sqrt(count));
    return {shift * shift / (count * count), 0.};
  }
  const double difference = end->by_parabola - end->by_last_node;
  return {end->shift * end->shift / (count * count),
          (2. * std::abs(end->shift * difference) + difference * difference) / (count * count)};
}

}  // namespace

FittedPeak fitted_peak(const Nodes& nodes) {
  constexpr double share = 0.9;
  constexpr std::size_t fewest = 5;
  const auto top = top_of(nodes);
  if (top == nodes.end() || top->pressure <= 0.) return {0., 0., 0.};
  Stretch around = stretch_around(nodes, top, [&](const ContactNode<2>& node) {
    return node.pressure >= share * top->pressure;
  });
  if (around.size() < fewest) around = neighbours_of(nodes, top, fewest / 2);
  if (around.size() < fewest) return maximum_node(nodes, top);
  const auto [begin, end] = around;
  const std::size_t count = around.size();
  const bool at_start = begin == nodes.begin();
  const bool at_end = end == nodes.end();
  const double first = begin->arc_length;
  const double last = (end - 1)->arc_length;
  const double origin = at_start ? first : at_end ? last : 0.5 * (first + last);
  const double reach = last - first;
  std::vector<std::array<double, 3>> samples;
  for (auto node = begin; node != end; ++node)
    samples.push_back({(node->arc_length - origin) / reach,
                       std::pow(node->pressure / top->pressure, 2), node->tributary});
  const Eigen::Vector3d c = weighted_parabola(samples, at_start != at_end);
  const double place = c(2) < 0. ? -c(1) / (2. * c(2)) : 0.;
  const double square = c(0) + place * (c(1) + place * c(2));
  const bool is_top = c(2) < 0. && std::abs(place) <= 0.5 && square > 0.;
  if (!is_top) return {top->pressure, 0., 0.};
  const double edge = 1. / static_cast<double>(count - 1);  // over the reach
  return {top->pressure * std::sqrt(square), -c(2) * edge * edge / (12. * square),
          0.5 * confidence(samples, c) / square};
}

EndShare share_of_free_ends(const ContactResult<2>& contact) {
  const auto run = hertzian_run(contact);
  if (!run) return {0., 0.};
  const Nodes& nodes = contact.nodes;
  EndShare sum{0., 0.};
  const auto add = [&](const std::size_t edge, const int inwards, const std::size_t to_top) {
    const EndShare share =
        share_of_end(free_end(nodes, edge, inwards, run->nodes.size()),
                     nodes[edge].pressure / nodes[run->nodes.top].pressure, to_top);
    sum.share += (run->has_image ? 2. : 1.) * share.share;
    sum.doubt += (run->has_image ? 2. : 1.) * share.doubt;
  };
  if (run->starts_free) add(run->nodes.first, 1, run->nodes.before_top());
  if (run->ends_free) add(run->nodes.last, -1, run->nodes.after_top());
  return sum;
}

double share_of_target(const ContactResult<2>& contact, const TargetEdges& target) {
  constexpr double measured = 0.2;
  const auto run = hertzian_run(contact);
  if (!run) return 0.;
  const auto count = static_cast<double>(run->nodes.size());
  const double across = run->has_image ? 2. * count - 1. : count;
  return measured * target.share * (target.ratio * target.ratio - 1.) / (across * across);
}

void correct_for_nodes(ContactResult<2>& contact, const TargetEdges& target) {
  contact.peak_pressure *=
      (1. + fitted_peak(contact.nodes).averaging) /
      (1. + share_of_free_ends(contact).share + share_of_target(contact, target));
}

}  // namespace geneva::fem
