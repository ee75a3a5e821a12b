#include "post/analysis/contact_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/symmetry.h"

namespace geneva::post {

using dealii::Point;
using dealii::Tensor;

namespace {

using Node = fem::ContactNode<3>;

/// Lowest and highest place along a direction where the surfaces face each other.
std::pair<double, double> extent_along(const fem::ContactResult<3>& contact,
                                       const Tensor<1, 3>& direction) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes) {
    const double place = Tensor<1, 3>(place_of(node)) * direction;
    lowest = std::min(lowest, place);
    highest = std::max(highest, place);
  }
  return {lowest, highest};
}

/// Curvatures of a surface in the directions of its tangent plane, positive where it bulges [1/m].
Tensor<2, 3> curvatures(const fem::Solution<3>& solution, const int circle, const bool is_convex,
                        const ContactFrame& frame) {
  Tensor<2, 3> tensor;
  if (circle < 0) return tensor;
  const mesh::Circle& shape = solution.mesh.circles[static_cast<std::size_t>(circle)];
  if (shape.ring_radius > 0.) return tensor;  // it changes along the contact: no closed form
  const auto curvature = mesh::curvature(shape, {frame.centre[0], frame.centre[1], frame.centre[2]},
                                         {frame.normal[0], frame.normal[1], frame.normal[2]});
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k) tensor[i][k] = (is_convex ? 1. : -1.) * curvature[i][k];
  return tensor;
}

/// Directions of the minimum and the maximum curvature in the tangent plane; along z where both are
/// equal, or where only the gap's clearance curves along z.
void set_directions(ContactFrame& frame, const Tensor<2, 3>& curvature, const bool is_along_z) {
  const Tensor<1, 3> x_axis({1., 0., 0.});
  const Tensor<1, 3>& start = std::abs(frame.normal[2]) < 0.9 ? z_axis : x_axis;
  frame.along = start - (start * frame.normal) * frame.normal;
  frame.along /= frame.along.norm();
  frame.across = dealii::cross_product_3d(frame.normal, frame.along);
  const double mixed = frame.across * (curvature * frame.along);
  const double excess =
      frame.across * (curvature * frame.across) - frame.along * (curvature * frame.along);
  const double rounding = 1e-6 * curvature.norm();
  if (is_along_z || (std::abs(mixed) <= rounding && excess >= -rounding)) return;
  // the tensor's principal directions are those of the angle with tan 2 angle = 2 mixed/excess
  const double angle = std::atan2(2. * mixed, excess) / 2.;
  const Tensor<1, 3> across = std::cos(angle) * frame.across + std::sin(angle) * frame.along;
  frame.along = dealii::cross_product_3d(across, frame.normal);
  frame.across = across;
}

}  // namespace

Point<3> place_of(const Node& node) {
  return {node.position[0], node.position[1], node.position[2]};
}

const fem::ContactPair& pair_of(const fem::Solution<3>& solution,
                                const fem::ContactResult<3>& contact) {
  return *std::find_if(solution.problem.pairs.begin(), solution.problem.pairs.end(),
                       [&](const fem::ContactPair& pair) { return pair.source == contact.source; });
}

double second_difference(const fem::ContactPair& pair, const double z, const double step) {
  if (!pair.clearance) return 0.;
  return (pair.clearance(z + step) - 2. * pair.clearance(z) + pair.clearance(z - step)) /
         (step * step);
}

namespace {

Extent loaded_part(const fem::ContactResult<3>& contact, const Tensor<1, 3>& direction) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Node& node : contact.nodes)
    if (is_closed(node.status)) {
      const double place = Tensor<1, 3>(place_of(node)) * direction;
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
    }
  return {lowest, highest};
}

Extent with_mirrored_part(const Extent& part, const ContactFrame& frame,
                          const Tensor<1, 3>& direction) {
  if (!frame.is_mirrored(direction)) return part;
  const auto& [lowest, highest] = part;
  const double plane = Tensor<1, 3>(frame.centre) * direction;
  const double reach = std::max(plane - lowest, highest - plane);
  return {plane - reach, plane + reach};
}

}  // namespace

Extent loaded_extent(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                     const Tensor<1, 3>& direction) {
  return with_mirrored_part(loaded_part(contact, direction), frame, direction);
}

Extent whole_extent(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                    const Tensor<1, 3>& direction) {
  return with_mirrored_part(extent_along(contact, direction), frame, direction);
}

double common_length(const fem::ContactResult<3>& contact, const ContactFrame& frame) {
  const auto [lowest, highest] = whole_extent(contact, frame, z_axis);
  return highest - lowest;
}

double ContactFrame::depth(const Point<3>& place) const {
  return std::abs((place - centre) * normal);
}

double ContactFrame::distance_across(const Point<3>& place) const {
  return (place - centre) * across;
}

double ContactFrame::distance_along(const Point<3>& place) const {
  return (place - centre) * along;
}

double ContactFrame::parts() const {
  return std::pow(2., std::count(mirrored.begin(), mirrored.end(), true));
}

bool ContactFrame::is_mirrored(const Tensor<1, 3>& direction) const {
  for (unsigned int i = 0; i < 3; ++i)
    if (mirrored[i] && std::abs(direction[i]) > 1. - 1e-6) return true;
  return false;
}

ContactFrame contact_frame(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact) {
  ContactFrame frame{};
  double force = 0.;
  Tensor<1, 3> place;
  for (const Node& node : contact.nodes) {
    const double share = node.pressure * node.tributary;
    force += share;
    place += share * Tensor<1, 3>(place_of(node));
    for (unsigned int i = 0; i < 3; ++i) frame.normal[i] += share * node.normal[i];
  }
  if (force <= 0.) return frame;
  frame.centre = Point<3>(place / force);
  for (unsigned int i = 0; i < 3; ++i)
    if (const auto plane = fem::symmetry_plane(solution.mesh, solution.problem, contact, i)) {
      frame.mirrored[i] = true;
      frame.centre[i] = *plane;
      frame.normal[i] = 0.;
    }
  frame.normal /= frame.normal.norm();
  const Tensor<2, 3> curvature =
      curvatures(solution, contact.source_circle, contact.source_is_convex, frame) +
      curvatures(solution, contact.target_circle, contact.target_is_convex, frame);
  const fem::ContactPair& pair = pair_of(solution, contact);
  set_directions(frame, curvature, static_cast<bool>(pair.clearance));
  const auto [lowest, highest] = loaded_part(contact, frame.along);
  const double step = 0.02 * (highest - lowest);
  frame.curvature_across = frame.across * (curvature * frame.across);
  frame.curvature_along = frame.along * (curvature * frame.along) +
                          (step > 0. ? second_difference(pair, frame.centre[2], step) : 0.);
  for (const Node& node : contact.nodes) {
    const double share = node.pressure * node.tributary / force;
    const double across = frame.distance_across(place_of(node));
    const double along = frame.distance_along(place_of(node));
    frame.mean_square_across += share * across * across;
    frame.mean_square_along += share * along * along;
  }
  return frame;
}

}  // namespace geneva::post
