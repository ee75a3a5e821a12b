#pragma once

#include <vector>

#include "loads/synthesis/path_equations.h"

namespace geneva::loads {

/// Where Newton's method ended.
struct NewtonEnd {
  PathUnknowns unknowns;
  double residual;          ///< maximum of the 4N equations at the end
  double minimum_residual;  ///< the same at the best iterate that was a proper linkage
  int iterations;
  bool converged;  ///< the residual is at the level of rounding
};

/// Whether no link has (nearly) vanished and none is out of all proportion: AB, BC, CD and AD
/// between 1e-3 and 100 times the extent of the points, and the chain closes with room to move.
///
/// With BC = 0, A = D and AB = CD the equations hold at any points: the chain has then two degrees
/// of freedom and generates nothing. Such ends of Newton's method are no solutions.
/// @param dimensions in units of the extent of the points
bool is_proper(const Eigen::Matrix<double, 9, 1>& dimensions);

/// Newton's method on the 4N equations of Lecture 4 with as many unknowns: the 3N angles and the
/// free dimensions (indices into PathUnknowns::dimensions, N of them).
///
/// The Jacobian is analytic; each point's angles occur in its own four equations only and are
/// eliminated first, so that a step costs N small factorisations and one N x N system instead of
/// one of 4N x 4N; the step is the same. A step is shortened to `longest_step` in its maximum
/// component but need not make |F| smaller.
/// @param points of an extent near 1 (the unit of the longest step and of the tolerance 1e-12)
NewtonEnd solve_path(const Eigen::Matrix2Xd& points, const std::vector<Eigen::Index>& free,
                     const PathUnknowns& start, int most_iterations);

}  // namespace geneva::loads
