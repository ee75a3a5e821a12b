#pragma once

#include <array>
#include <utility>
#include <vector>

namespace geneva::loads {

/// Planar four-bar linkage A B C D with a point P of its coupler; lengths in m, angles in rad from
/// the x axis of the frame in which the pivots are given.
struct FourBar {
  std::array<double, 2> crank_pivot;   ///< A
  std::array<double, 2> rocker_pivot;  ///< D
  double crank;                        ///< AB > 0
  double coupler;                      ///< BC > 0
  double rocker;                       ///< CD > 0
  double point_distance;               ///< BP >= 0
  double point_angle;                  ///< alpha, from BC to BP, positive counter-clockwise
};

/// The two ways of closing a linkage at one crank angle: C lies to the left of the straight line
/// from B to D (open) or to its right (crossed), that is, cross(BD, BC) is positive or negative.
///
/// With A on the left, D on the right and the crank pointing upwards, the open linkage looks open.
/// The sign changes only where B, C and D are in line. If the crank turns fully, it never does:
/// each assembly is a closed motion of its own. If not, both assemblies meet at the ends of the
/// crank's ranges. At a change point (equality in Grashof's condition) all links are in line, and
/// the mechanism can pass from one to the other in mid-motion. A parallelogram has two: open stands
/// for its coupler that stays parallel to the frame, crossed for the antiparallelogram, whose
/// smooth motion goes through both.
enum class Assembly { open, crossed };

/// Angles and coupler point at one crank angle phi_2: value and first three derivatives with
/// respect to phi_2.
struct FourBarMotion {
  std::array<double, 4> coupler_angle;  ///< phi_3 of BC [rad], value in [-pi, pi]
  std::array<double, 4> rocker_angle;   ///< phi_4 of DC [rad], value in [-pi, pi]
  std::array<double, 4> x;              ///< X_P [m]
  std::array<double, 4> y;              ///< Y_P [m]
};

/// AD [m]
double frame_length(const FourBar& linkage);

/// Refuses a linkage that does not exist.
/// @throws base::InputError unless AB, BC, CD and AD are positive and finite, BP is finite and
/// not negative, alpha is finite and the longest of the four lengths is shorter than the others
/// together
void check(const FourBar& linkage);

/// Whether B can go round its whole circle (Grashof): |AD - AB| >= |BC - CD| and AD + AB <= BC +
/// CD, equality (to rounding) included.
/// @throws base::InputError where check() does
bool crank_turns_fully(const FourBar& linkage);

/// Crank angles [rad] at which all links are in line though the crank can go on: none, gamma, gamma
/// + pi or both, with gamma the angle of AD.
/// @throws base::InputError where check() does
std::vector<double> change_points(const FourBar& linkage);

/// Whether a linkage is a parallelogram whose coupler stays parallel to the frame.
bool stays_parallelogram(const FourBar& linkage, Assembly assembly);

/// Intervals {first, last} of the crank angle [rad] in which the linkage can be assembled, first in
/// [gamma - pi, gamma + pi] with gamma the angle of AD: {gamma, gamma + 2 pi} if the crank turns
/// fully, otherwise one or two intervals that end where B, C and D are in line.
/// @throws base::InputError where check() does
std::vector<std::pair<double, double>> crank_ranges(const FourBar& linkage);

/// Position in closed form; velocity, acceleration and jerk from the closure equations of Lecture 4
/// (AB cos phi_2 + BC cos phi_3 - DC cos phi_4 + X_A - X_D = 0, and with sines) differentiated
/// once, twice and three times.
/// @param crank_angle phi_2 [rad], any turn
/// @throws base::InputError where check() does, and if the linkage cannot be assembled at the
/// crank angle or stands at a dead point there (sine of the angle between coupler and rocker below
/// 1e-7), naming the ranges of the crank; a parallelogram that stays one has no dead point
FourBarMotion motion(const FourBar& linkage, Assembly assembly, double crank_angle);

/// Both closures at a crank angle, open and crossed.
/// @throws base::InputError where motion() does
std::array<FourBarMotion, 2> all_assemblies(const FourBar& linkage, double crank_angle);

}  // namespace geneva::loads
