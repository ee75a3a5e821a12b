#include "loads/synthesis/path_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geneva::loads {

namespace {

/// Room for nine points without allocation.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 9, 9>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;

/// Half an extent and half a radian. Steps that must make |F| smaller (Levenberg and Marquardt's
/// damping) end in local minima or in the chain of is_proper(): of 1000 starts at nine points of
/// six linkages they led to 0 to 7 solutions, the shortened step to 15 to 35.
constexpr double longest_step = 0.5;
constexpr double maximum_dimension = 100.;
constexpr double minimum_link = 1e-3;

/// Linearised equations with the angles eliminated: matrix * step of free dimensions = -residual.
struct Reduced {
  SmallMatrix matrix;
  SmallVector residual;
  std::vector<PointEquations> equations;
  std::vector<Eigen::HouseholderQR<Eigen::Matrix<double, 4, 3>>> factors;
  double maximum;  // of all 4N equations
};

void reduce(const PathUnknowns& unknowns, const Eigen::Matrix2Xd& points,
            const std::vector<Eigen::Index>& free, Reduced& reduced) {
  reduced.matrix.resize(points.cols(), points.cols());
  reduced.residual.resize(points.cols());
  reduced.equations.clear();
  reduced.factors.clear();
  reduced.maximum = 0.;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const PointEquations& e =
        reduced.equations.emplace_back(point_equations(unknowns, i, points.col(i)));
    const auto& qr = reduced.factors.emplace_back(e.by_angles);
    // the combination of the four equations in which the angles do not occur
    Eigen::Vector4d combination = Eigen::Vector4d::UnitW();
    combination.applyOnTheLeft(qr.householderQ());
    for (std::size_t j = 0; j < free.size(); ++j)
      reduced.matrix(i, static_cast<Eigen::Index>(j)) =
          combination.dot(e.by_dimensions.col(free[j]));
    reduced.residual[i] = combination.dot(e.residual);
    reduced.maximum = std::max(reduced.maximum, e.residual.cwiseAbs().maxCoeff());
  }
}

/// The whole Newton step.
PathUnknowns newton_step(const std::vector<Eigen::Index>& free, const Reduced& reduced) {
  const SmallVector of_free = reduced.matrix.partialPivLu().solve(-reduced.residual);
  const auto count = static_cast<Eigen::Index>(reduced.equations.size());
  PathUnknowns step{Eigen::Matrix<double, 9, 1>::Zero(), Eigen::Matrix3Xd(3, count)};
  for (std::size_t j = 0; j < free.size(); ++j)
    step.dimensions[free[j]] = of_free[static_cast<Eigen::Index>(j)];
  for (std::size_t i = 0; i < reduced.equations.size(); ++i) {
    const PointEquations& e = reduced.equations[i];
    step.angles.col(static_cast<Eigen::Index>(i)) =
        -reduced.factors[i].solve(e.residual + e.by_dimensions * step.dimensions);
  }
  return step;
}

PathUnknowns moved(const PathUnknowns& unknowns, const PathUnknowns& step, double factor) {
  return {unknowns.dimensions + factor * step.dimensions, unknowns.angles + factor * step.angles};
}

}  // namespace

bool is_proper(const Eigen::Matrix<double, 9, 1>& dimensions) {
  const Eigen::Vector4d links(std::abs(dimensions[4]), std::abs(dimensions[5]),
                              std::abs(dimensions[6]),
                              (dimensions.segment<2>(2) - dimensions.segment<2>(0)).norm());
  const double longest = links.maxCoeff();
  return links.minCoeff() > minimum_link && std::abs(dimensions[7]) < maximum_dimension &&
         longest < maximum_dimension && longest < (1. - 1e-9) * (links.sum() - longest);
}

NewtonEnd solve_path(const Eigen::Matrix2Xd& points, const std::vector<Eigen::Index>& free,
                     const PathUnknowns& start, int most_iterations) {
  constexpr double near = 1e-9;  // from here a step that gains nothing has met the rounding
  constexpr double rounding = 1e-12;
  NewtonEnd end{start, 0., INFINITY, 0, false};
  Reduced reduced;
  reduce(end.unknowns, points, free, reduced);
  Reduced next;
  while (end.iterations < most_iterations) {
    if (is_proper(end.unknowns.dimensions))
      end.minimum_residual = std::min(end.minimum_residual, reduced.maximum);
    const PathUnknowns step = newton_step(free, reduced);
    const double maximum =
        std::max(step.dimensions.cwiseAbs().maxCoeff(), step.angles.cwiseAbs().maxCoeff());
    if (!std::isfinite(maximum)) break;  // singular Jacobian
    const PathUnknowns trial = moved(end.unknowns, step, std::min(1., longest_step / maximum));
    ++end.iterations;
    reduce(trial, points, free, next);
    if (reduced.maximum < near && !(next.maximum < 0.5 * reduced.maximum)) break;
    end.unknowns = trial;
    std::swap(reduced, next);
    if (end.unknowns.dimensions.head<8>().cwiseAbs().maxCoeff() > maximum_dimension) break;
  }
  end.residual = reduced.maximum;
  end.converged = reduced.maximum < rounding;
  return end;
}

}  // namespace geneva::loads
