#include "loads/motion/four_bar.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

using Vector = Eigen::Vector2d;
using VectorDerivatives = std::array<Vector, 4>;

/// Below this sine C's distance from the line BD is lost in rounding, sqrt(2^-52) = 1.5e-8.
constexpr double dead_point_sine = 1e-7;

Vector direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

Vector left_of(const Vector& v) { return {-v.y(), v.x()}; }

Vector crank_pin(const FourBar& linkage, double crank_angle) {
  return Vector(linkage.crank_pivot.data()) + linkage.crank * direction(crank_angle);
}

double frame_angle(const FourBar& linkage) {
  return std::atan2(linkage.rocker_pivot[1] - linkage.crank_pivot[1],
                    linkage.rocker_pivot[0] - linkage.crank_pivot[0]);
}

/// Difference of link lengths that is nothing but the rounding of sums of two.
double rounding(const FourBar& linkage) {
  return 4. * std::numeric_limits<double>::epsilon() *
         (linkage.crank + linkage.coupler + linkage.rocker + frame_length(linkage));
}

/// What is left before coupler and rocker overlap when B is nearest to D.
double inner_room(const FourBar& linkage) {
  return std::abs(frame_length(linkage) - linkage.crank) -
         std::abs(linkage.coupler - linkage.rocker);
}

/// What is left before coupler and rocker are stretched when B is farthest from D.
double outer_room(const FourBar& linkage) {
  return linkage.coupler + linkage.rocker - frame_length(linkage) - linkage.crank;
}

/// B can go to its point nearest to D without coupler and rocker being folded beyond their overlap.
bool passes_inner_end(const FourBar& linkage) { return inner_room(linkage) >= -rounding(linkage); }

/// B can go to its point farthest from D.
bool passes_outer_end(const FourBar& linkage) { return outer_room(linkage) >= -rounding(linkage); }

bool is_parallelogram(const FourBar& linkage) {
  return std::abs(linkage.crank - linkage.rocker) <= rounding(linkage) &&
         std::abs(frame_length(linkage) - linkage.coupler) <= rounding(linkage);
}

/// Angle opposite to `opposite` in a triangle, from the half-angle formula: it loses no digits in
/// flat triangles, as the cosine rule does.
double triangle_angle(double opposite, double side, double other) {
  const double inner = (opposite - (side - other)) * (opposite + (side - other));
  const double outer = ((side + other) - opposite) * ((side + other) + opposite);
  return 2. * std::atan2(std::sqrt(std::max(0., inner)), std::sqrt(std::max(0., outer)));
}

std::string describe_ranges(const FourBar& linkage) {
  if (crank_turns_fully(linkage)) return "any crank angle";
  std::string text = "crank angles";
  for (const auto& [first, last] : crank_ranges(linkage))
    text += fmt::format("{} from {:.6g} deg to {:.6g} deg", text == "crank angles" ? "" : " and",
                        first / degree, last / degree);
  return text;
}

/// Value and derivatives of a turning vector from its value and the derivatives of its angle.
VectorDerivatives turning(const Vector& along, const std::array<double, 4>& angle) {
  const Vector across = left_of(along);
  return {along, angle[1] * across, angle[2] * across - angle[1] * angle[1] * along,
          (angle[3] - angle[1] * angle[1] * angle[1]) * across - 3. * angle[1] * angle[2] * along};
}

/// The links as vectors AB, BC and DC.
struct Links {
  Vector crank;
  Vector coupler;
  Vector rocker;
};

Links links(const FourBar& linkage, double crank_angle, const FourBarMotion& state) {
  return {linkage.crank * direction(crank_angle),
          linkage.coupler * direction(state.coupler_angle[0]),
          linkage.rocker * direction(state.rocker_angle[0])};
}

/// The closure equations differentiated `order` times without their terms in the derivatives of
/// that order, which must still be 0 in coupler and rocker.
Vector closure(const Links& links, const FourBarMotion& state, std::size_t order) {
  return turning(links.crank, {0., 1., 0., 0.})[order] +
         turning(links.coupler, state.coupler_angle)[order] -
         turning(links.rocker, state.rocker_angle)[order];
}

/// Triangle B C D: the closed form of position.
void close_position(const FourBar& linkage, Assembly assembly, double crank_angle,
                    FourBarMotion& state) {
  const Vector pin = crank_pin(linkage, crank_angle);
  const Vector to_rocker_pivot = Vector(linkage.rocker_pivot.data()) - pin;
  const double distance = to_rocker_pivot.norm();
  const double between = std::abs(linkage.coupler - linkage.rocker);
  const double slack = rounding(linkage);
  if (distance < between - slack || distance > linkage.coupler + linkage.rocker + slack)
    throw base::InputError(fmt::format(
        "crank angle is {:.6g} deg, where coupler and rocker cannot meet: B is {:.6g} mm from D, "
        "not {:.6g} to {:.6g} mm; choose {}",
        crank_angle / degree, 1e3 * distance, 1e3 * between,
        1e3 * (linkage.coupler + linkage.rocker), describe_ranges(linkage)));
  const double side = assembly == Assembly::open ? 1. : -1.;
  const double at_pin = triangle_angle(linkage.rocker, linkage.coupler, distance);
  const double coupler_angle = std::atan2(to_rocker_pivot.y(), to_rocker_pivot.x()) + side * at_pin;
  const Vector rocker = linkage.coupler * direction(coupler_angle) - to_rocker_pivot;
  state.coupler_angle[0] = coupler_angle;
  state.rocker_angle[0] = std::atan2(rocker.y(), rocker.x());
}

/// d(closure)/d(phi_3, phi_4); its determinant is BC CD sin(phi_3 - phi_4).
Eigen::Matrix2d closure_jacobian(const Links& links) {
  Eigen::Matrix2d jacobian;
  jacobian << left_of(links.coupler), -left_of(links.rocker);
  return jacobian;
}

void refuse_dead_point(const FourBar& linkage, double crank_angle, const FourBarMotion& state) {
  const double sine = std::sin(state.coupler_angle[0] - state.rocker_angle[0]);
  if (std::abs(sine) >= dead_point_sine) return;
  throw base::InputError(fmt::format(
      "crank angle is {:.6g} deg, a dead point: coupler and rocker are in line and their speeds "
      "have no bound or no sense; choose {} away from the ends and from that point",
      crank_angle / degree, describe_ranges(linkage)));
}

/// From the closure equations, each order with the same matrix.
void differentiate(const FourBar& linkage, double crank_angle, FourBarMotion& state) {
  const Links vectors = links(linkage, crank_angle, state);
  const Eigen::PartialPivLU<Eigen::Matrix2d> jacobian(closure_jacobian(vectors));
  for (std::size_t order = 1; order < 4; ++order) {
    const Vector highest = jacobian.solve(-closure(vectors, state, order));
    state.coupler_angle[order] = highest[0];
    state.rocker_angle[order] = highest[1];
  }
}

/// The coupler stays parallel to the frame and the rocker to the crank.
FourBarMotion parallel_motion(const FourBar& linkage, double crank_angle) {
  FourBarMotion state{};
  state.coupler_angle[0] = frame_angle(linkage);
  state.rocker_angle = {std::remainder(crank_angle, 2. * pi), 1., 0., 0.};
  return state;
}

/// The side of the straight line BD on which the antiparallelogram goes on smoothly.
Assembly antiparallel(const FourBar& linkage, double crank_angle) {
  return std::sin(crank_angle - frame_angle(linkage)) > 0. ? Assembly::crossed : Assembly::open;
}

FourBarMotion closed_motion(const FourBar& linkage, Assembly assembly, double crank_angle) {
  FourBarMotion state{};
  close_position(linkage, assembly, crank_angle, state);
  refuse_dead_point(linkage, crank_angle, state);
  differentiate(linkage, crank_angle, state);
  return state;
}

void set_point(const FourBar& linkage, double crank_angle, FourBarMotion& state) {
  const VectorDerivatives pin =
      turning(linkage.crank * direction(crank_angle), {crank_angle, 1., 0., 0.});
  const VectorDerivatives arm =
      turning(linkage.point_distance * direction(state.coupler_angle[0] + linkage.point_angle),
              state.coupler_angle);
  for (std::size_t order = 0; order < 4; ++order) {
    state.x[order] = pin[order].x() + arm[order].x();
    state.y[order] = pin[order].y() + arm[order].y();
  }
  state.x[0] += linkage.crank_pivot[0];
  state.y[0] += linkage.crank_pivot[1];
}

}  // namespace

double frame_length(const FourBar& linkage) {
  return std::hypot(linkage.rocker_pivot[0] - linkage.crank_pivot[0],
                    linkage.rocker_pivot[1] - linkage.crank_pivot[1]);
}

void check(const FourBar& linkage) {
  const double frame = frame_length(linkage);
  require_positive_length("crank AB", linkage.crank);
  require_positive_length("coupler BC", linkage.coupler);
  require_positive_length("rocker CD", linkage.rocker);
  require_positive_length("distance of the pivots AD", frame);
  require_not_negative("distance BP of the coupler point", 1e3 * linkage.point_distance, "mm");
  require_finite("angle of the coupler point", linkage.point_angle / degree, "deg");
  const double longest = std::max({linkage.crank, linkage.coupler, linkage.rocker, frame});
  const double others = linkage.crank + linkage.coupler + linkage.rocker + frame - longest;
  if (longest < others) return;
  throw base::InputError(fmt::format(
      "lengths are AB {:.6g}, BC {:.6g}, CD {:.6g} and AD {:.6g} mm: the longest, {:.6g} mm, must "
      "be shorter than the other three together, {:.6g} mm, or the linkage cannot be closed; "
      "shorten it or lengthen the others",
      1e3 * linkage.crank, 1e3 * linkage.coupler, 1e3 * linkage.rocker, 1e3 * frame, 1e3 * longest,
      1e3 * others));
}

bool crank_turns_fully(const FourBar& linkage) {
  check(linkage);
  // BD runs from |AD - AB| to AD + AB as the crank turns and must be a side of a triangle with BC
  // and CD all the way. The two conditions together say that AB or AD is the shortest link and that
  // shortest + longest <= the other two.
  return passes_inner_end(linkage) && passes_outer_end(linkage);
}

std::vector<double> change_points(const FourBar& linkage) {
  check(linkage);
  std::vector<double> angles;
  if (std::abs(inner_room(linkage)) <= rounding(linkage)) angles.push_back(frame_angle(linkage));
  if (std::abs(outer_room(linkage)) <= rounding(linkage))
    angles.push_back(frame_angle(linkage) + pi);
  return angles;
}

bool stays_parallelogram(const FourBar& linkage, const Assembly assembly) {
  return assembly == Assembly::open && is_parallelogram(linkage);
}

std::vector<std::pair<double, double>> crank_ranges(const FourBar& linkage) {
  check(linkage);
  const double frame = frame_length(linkage);
  const double angle = frame_angle(linkage);
  const bool inner = passes_inner_end(linkage);
  const bool outer = passes_outer_end(linkage);
  if (inner && outer) return {{angle, angle + 2. * pi}};
  // angles from AD at which BD = |BC - CD| (folded) and BD = BC + CD (stretched)
  const double folded =
      triangle_angle(std::abs(linkage.coupler - linkage.rocker), linkage.crank, frame);
  const double stretched = triangle_angle(linkage.coupler + linkage.rocker, linkage.crank, frame);
  if (outer) return {{angle + folded, angle + 2. * pi - folded}};
  if (inner) return {{angle - stretched, angle + stretched}};
  return {{angle - stretched, angle - folded}, {angle + folded, angle + stretched}};
}

FourBarMotion motion(const FourBar& linkage, Assembly assembly, double crank_angle) {
  check(linkage);
  require_finite("crank angle", crank_angle / degree, "deg");
  FourBarMotion state =
      stays_parallelogram(linkage, assembly)
          ? parallel_motion(linkage, crank_angle)
          : closed_motion(linkage,
                          is_parallelogram(linkage) ? antiparallel(linkage, crank_angle) : assembly,
                          crank_angle);
  set_point(linkage, crank_angle, state);
  state.coupler_angle[0] = std::remainder(state.coupler_angle[0], 2. * pi);
  return state;
}

std::array<FourBarMotion, 2> all_assemblies(const FourBar& linkage, double crank_angle) {
  return {motion(linkage, Assembly::open, crank_angle),
          motion(linkage, Assembly::crossed, crank_angle)};
}

}  // namespace geneva::loads
