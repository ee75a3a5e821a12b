#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "loads/motion/four_bar.h"

namespace geneva::loads {

/// The unknowns of the path synthesis (Lecture 4) at all points: the nine dimensions X_A, Y_A, X_D,
/// Y_D, AB, BC, CD, BP, alpha, and one column phi_2, phi_3, phi_4 for each point.
struct PathUnknowns {
  Eigen::Matrix<double, 9, 1> dimensions;
  Eigen::Matrix3Xd angles;
};

/// The four equations of one point with the non-zero blocks of their Jacobian.
struct PointEquations {
  Eigen::Vector4d residual;
  Eigen::Matrix<double, 4, 9> by_dimensions;
  Eigen::Matrix<double, 4, 3> by_angles;
};

/// Closure of A B C D and of A B P at the point (Lecture 4): AB cos phi_2 + BC cos phi_3 - DC cos
/// phi_4 + X_A - X_D, with sines, AB cos phi_2 + BP cos(phi_3 + alpha) + X_A - X_P, with sines.
/// @param i index of the point's column of angles
PointEquations point_equations(const PathUnknowns& unknowns, Eigen::Index i,
                               const Eigen::Vector2d& point);

/// Residuals of point_equations() of all points, four rows a column.
Eigen::Matrix4Xd path_residual(const PathUnknowns& unknowns, const Eigen::Matrix2Xd& points);

/// The same linkage with positive lengths, alpha and all angles in [-pi, pi]: a negative length is
/// the positive one turned by pi.
PathUnknowns normalised(const PathUnknowns& unknowns);

/// The same linkage with crank and rocker named the other way round.
PathUnknowns with_rocker_as_crank(const PathUnknowns& unknowns);

/// A cognate (Roberts): another linkage on the pivot A with the same coupler curve. Together with
/// with_rocker_as_crank() it generates the three cognates, each in two forms.
PathUnknowns cognate(const PathUnknowns& unknowns);

FourBar linkage_of(const PathUnknowns& unknowns);

}  // namespace geneva::loads
