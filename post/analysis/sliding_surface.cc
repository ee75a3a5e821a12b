#include "post/analysis/sliding_surface.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "mesh/dense_algebra.h"
#include "post/analysis/surface_body.h"

namespace geneva::post {

namespace {

double stress_of(const double strain, const double pressure, const loads::Elastic& material,
                 const fem::PlaneKind plane) {
  const auto [modulus, nu] = material;
  return plane == fem::PlaneKind::plane_stress
             ? modulus * strain - nu * pressure
             : modulus / (1. - nu * nu) * strain - nu / (1. - nu) * pressure;
}

/// Next to the end of a contact the pressure changes too fast for the nodes.
constexpr std::size_t skipped = 2;
constexpr std::size_t fewest = 12;

/// Indices of the first and last node in contact around the peak pressure.
std::pair<std::size_t, std::size_t> closed_range(const std::vector<fem::ContactNode<2>>& nodes) {
  const auto top = static_cast<std::size_t>(
      std::max_element(nodes.begin(), nodes.end(),
                       [](const auto& a, const auto& b) { return a.pressure < b.pressure; }) -
      nodes.begin());
  std::size_t first = top;
  std::size_t last = top;
  while (first > 0 && fem::is_closed(nodes[first - 1].status)) --first;
  while (last + 1 < nodes.size() && fem::is_closed(nodes[last + 1].status)) ++last;
  return {first, last};
}

/// The value at x = 0 of the parabola through points (x, value).
double extrapolated(const std::vector<std::pair<double, double>>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd values(matrix.rows());
  const double reach = points.back().first;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const auto& [place, value] = points[static_cast<std::size_t>(i)];
    const double x = place / reach;
    matrix.row(i) << 1., x, x * x;
    values(i) = value;
  }
  return mesh::least_squares(matrix, values)(0);
}

/// Sliding nodes from one end of the contact inwards.
struct SlidingEnd {
  double end;                      ///< arc length where the pressure falls to zero
  std::vector<std::size_t> nodes;  ///< from it inwards
};

SlidingEnd sliding_end(const std::vector<fem::ContactNode<2>>& nodes, const std::size_t from,
                       const std::size_t to, const double end) {
  SlidingEnd result{end, {}};
  std::size_t at = from;
  while (nodes[at].status == fem::NodeStatus::slip) {
    result.nodes.push_back(at);
    if (at == to) break;
    at = from < to ? at + 1 : at - 1;
  }
  return result;
}

/// Tension at that end of both surfaces, the greater one.
double tension_at(const SlidingEnd& end, const std::vector<fem::ContactNode<2>>& nodes,
                  const std::vector<SurfaceStress>& stresses) {
  const std::size_t count = end.nodes.size() / 2;
  constexpr std::size_t fewest_of_a_parabola = 5;
  if (count < skipped + fewest_of_a_parabola) return 0.;
  std::vector<std::pair<double, double>> source;
  std::vector<std::pair<double, double>> target;
  for (std::size_t k = skipped; k < count; ++k) {
    const std::size_t i = end.nodes[k];
    const double inwards = std::abs(nodes[i].arc_length - end.end);
    source.emplace_back(inwards, stresses[i].source + nodes[i].pressure);
    target.emplace_back(inwards, stresses[i].target + nodes[i].pressure);
  }
  return std::max(extrapolated(source), extrapolated(target));
}

}  // namespace

std::vector<SurfaceStress> surface_stresses(const fem::Solution<2>& solution,
                                            const fem::ContactResult<2>& contact) {
  const fem::PlaneKind plane = solution.problem.plane;
  if (plane == fem::PlaneKind::axisymmetric) return {};
  const loads::Elastic source = material_of(solution, contact.source);
  const loads::Elastic target = material_of(solution, contact.target);
  std::vector<SurfaceStress> stresses;
  for (const fem::ContactNode<2>& node : contact.nodes)
    stresses.push_back({stress_of(node.strain.source, node.pressure, source, plane),
                        stress_of(node.strain.target, node.pressure, target, plane)});
  return stresses;
}

std::optional<SurfaceExtremes> surface_extremes(const fem::Solution<2>& solution,
                                                const fem::ContactResult<2>& contact) {
  const std::vector<SurfaceStress> stresses = surface_stresses(solution, contact);
  const std::vector<fem::ContactNode<2>>& nodes = contact.nodes;
  // By the problem, which is the same on every rank: tractions differ by roundings.
  const auto& pairs = solution.problem.pairs;
  const bool has_friction =
      std::any_of(pairs.begin(), pairs.end(), [&](const fem::ContactPair& pair) {
        return pair.source == contact.source && pair.target == contact.target &&
               pair.friction.coefficient > 0.;
      });
  if (stresses.empty() || !has_friction) return std::nullopt;
  const std::pair<std::size_t, std::size_t> closed = closed_range(nodes);
  const std::size_t first = closed.first;
  const std::size_t last = closed.second;
  if (last - first + 1 < fewest) return std::nullopt;
  SurfaceExtremes result{0., 0., 0., {}};
  for (std::size_t i = first + skipped; i + skipped <= last; ++i) {
    const double friction = std::hypot(nodes[i].friction[0], nodes[i].friction[1]);
    for (const double along : {stresses[i].source, stresses[i].target}) {
      result.tension = std::max(result.tension, along);
      result.compression = std::max(result.compression, -along);
      const double shear = std::hypot((along + nodes[i].pressure) / 2., friction);
      if (shear <= result.shear) continue;
      result.shear = shear;
      result.shear_place = nodes[i].position;
    }
  }
  const auto interval = std::find_if(contact.intervals.begin(), contact.intervals.end(),
                                     [&](const fem::ContactInterval& one) {
                                       return one.begin <= nodes[first + skipped].arc_length &&
                                              one.end >= nodes[first + skipped].arc_length;
                                     });
  if (interval == contact.intervals.end()) return result;
  // Where the surface itself ends, at a plane of symmetry for one, the pressure is not zero.
  if (first > 0)
    result.tension =
        std::max(result.tension,
                 tension_at(sliding_end(nodes, first, last, interval->begin), nodes, stresses));
  if (last + 1 < nodes.size())
    result.tension =
        std::max(result.tension,
                 tension_at(sliding_end(nodes, last, first, interval->end), nodes, stresses));
  return result;
}

}  // namespace geneva::post
