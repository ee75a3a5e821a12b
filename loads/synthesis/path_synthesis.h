#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "loads/motion/four_bar.h"

namespace geneva::loads {

/// The nine dimensions of a path generator (Lecture 4).
enum class PathDimension {
  crank_pivot_x,   ///< X_A [m]
  crank_pivot_y,   ///< Y_A [m]
  rocker_pivot_x,  ///< X_D [m]
  rocker_pivot_y,  ///< Y_D [m]
  crank,           ///< AB [m]
  coupler,         ///< BC [m]
  rocker,          ///< CD [m]
  point_distance,  ///< BP [m]
  point_angle,     ///< alpha [rad]
};

struct GivenDimension {
  PathDimension dimension;
  double value;  ///< [m], or [rad] of point_angle; lengths > 0
};

/// What is asked: a four-bar linkage whose coupler point passes N points.
struct PathTask {
  std::vector<std::array<double, 2>> points;  ///< [m], 2 to 9, in the order wanted
  std::vector<GivenDimension> given;          ///< 9 - N of the nine dimensions
  /// Random starts of Newton's method, >= 0, each about 0.3 ms at nine points. Of 20 random
  /// linkages 1000 starts recover 15 from nine points of their curves, 3000 recover 17, 20 000 all.
  int starts = 3000;
  std::uint64_t seed = 1;             ///< the same seed gives the same result
  std::vector<FourBar> guesses = {};  ///< starts tried before the random ones
};

/// A linkage that passes all points, with what a designer must know before he builds it.
struct PathSolution {
  FourBar linkage;
  std::vector<double> crank_angles;  ///< phi_2 at the points [rad], in [-pi, pi]
  std::vector<Assembly> assemblies;  ///< at the points
  double residual;                   ///< maximum of the 4N equations of Lecture 4 [m]
  int iterations;                    ///< of Newton's method
  bool needs_reassembly;  ///< the points lie on both assemblies or in different ranges of the crank
  bool out_of_order;      ///< turning either way, the crank meets the points in another order
};

struct PathSynthesis {
  std::vector<PathSolution> solutions;  ///< without defects first, then by the longest link
  double minimum_residual;  ///< of the 4N equations, of all iterates that are proper linkages [m]
  int starts;               ///< that were made, guesses included
  int degenerate;           ///< starts that ended at a chain of vanishing or boundless links
};

/// Four-bar path generator through N <= 9 precision points: Newton's method on the 4N equations of
/// Lecture 4 in as many unknowns (at nine points 36), from many starts.
///
/// Each random start draws A, AB, BP and the place of C on the coupler in proportion to the extent
/// of the points, closes the dyad A B P at every point and takes for D and CD the circle that fits
/// the places of C best. Solutions that are the same linkage (negative lengths, turns of alpha) are
/// reported once. Without given dimensions each linkage found brings its cognates (Roberts) and the
/// forms with crank and rocker exchanged: six different generators of the same curve. No start
/// finds all solutions; that none is found does not prove that there is none. Links that are not
/// between 1e-3 and 100 times the extent of the points are not looked at.
/// @throws base::InputError unless there are 2 to 9 distinct finite points, exactly 9 - N
/// different dimensions are given with finite values (lengths positive), starts is not negative and
/// every guess passes check()
PathSynthesis synthesise_path(const PathTask& task);

}  // namespace geneva::loads
