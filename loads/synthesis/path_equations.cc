#include "loads/synthesis/path_equations.h"

#include <cmath>
#include <complex>

#include "loads/pi.h"

namespace geneva::loads {

namespace {

using Complex = std::complex<double>;

enum Row { xa, ya, xd, yd, ab, bc, cd, bp, alpha };
enum AngleRow { phi2, phi3, phi4 };

/// Unit vector at an angle and its derivative.
struct Direction {
  explicit Direction(double angle)
      : along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x()) {}
  Eigen::Vector2d along;
  Eigen::Vector2d across;
};

/// BP/BC turned by alpha: BP = ratio BC as complex numbers.
Complex coupler_ratio(const PathUnknowns& u) {
  return std::polar(1., u.dimensions[alpha]) * (u.dimensions[bp] / u.dimensions[bc]);
}

/// Turns all angles of a row by half a turn where the length that they carry is negative.
void make_positive(PathUnknowns& u, Row length, AngleRow angle) {
  if (u.dimensions[length] >= 0.) return;
  u.dimensions[length] *= -1.;
  u.angles.row(angle).array() += pi;
}

}  // namespace

PointEquations point_equations(const PathUnknowns& unknowns, Eigen::Index i,
                               const Eigen::Vector2d& point) {
  const auto& d = unknowns.dimensions;
  const Direction crank(unknowns.angles(phi2, i));
  const Direction coupler(unknowns.angles(phi3, i));
  const Direction rocker(unknowns.angles(phi4, i));
  const Direction arm(unknowns.angles(phi3, i) + d[alpha]);
  const Eigen::Vector2d pin = d.segment<2>(xa) + d[ab] * crank.along;

  PointEquations e;
  e.residual << pin + d[bc] * coupler.along - d[cd] * rocker.along - d.segment<2>(xd),
      pin + d[bp] * arm.along - point;
  e.by_dimensions.setZero();
  e.by_dimensions.topRows<2>().middleCols<2>(xa).setIdentity();
  e.by_dimensions.bottomRows<2>().middleCols<2>(xa).setIdentity();
  e.by_dimensions.topRows<2>().middleCols<2>(xd).diagonal().setConstant(-1.);
  e.by_dimensions.col(ab) << crank.along, crank.along;
  e.by_dimensions.col(bc).head<2>() = coupler.along;
  e.by_dimensions.col(cd).head<2>() = -rocker.along;
  e.by_dimensions.col(bp).tail<2>() = arm.along;
  e.by_dimensions.col(alpha).tail<2>() = d[bp] * arm.across;
  e.by_angles.col(phi2) << d[ab] * crank.across, d[ab] * crank.across;
  e.by_angles.col(phi3) << d[bc] * coupler.across, d[bp] * arm.across;
  e.by_angles.col(phi4) << -d[cd] * rocker.across, Eigen::Vector2d::Zero();
  return e;
}

Eigen::Matrix4Xd path_residual(const PathUnknowns& unknowns, const Eigen::Matrix2Xd& points) {
  Eigen::Matrix4Xd residual(4, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    residual.col(i) = point_equations(unknowns, i, points.col(i)).residual;
  return residual;
}

PathUnknowns normalised(const PathUnknowns& unknowns) {
  PathUnknowns u = unknowns;
  make_positive(u, ab, phi2);
  make_positive(u, cd, phi4);
  if (u.dimensions[bc] < 0.) u.dimensions[alpha] -= pi;  // phi_3 + alpha stays
  make_positive(u, bc, phi3);
  if (u.dimensions[bp] < 0.) {
    u.dimensions[bp] *= -1.;
    u.dimensions[alpha] += pi;
  }
  const auto wrap = [](double angle) { return std::remainder(angle, 2. * pi); };
  u.dimensions[alpha] = wrap(u.dimensions[alpha]);
  u.angles = u.angles.unaryExpr(wrap).eval();
  return u;
}

PathUnknowns with_rocker_as_crank(const PathUnknowns& unknowns) {
  const auto& d = unknowns.dimensions;
  const Complex ratio = 1. - coupler_ratio(unknowns);  // CP/CB
  PathUnknowns u = unknowns;
  u.dimensions << d[xd], d[yd], d[xa], d[ya], d[cd], d[bc], d[ab], std::abs(ratio) * d[bc],
      std::arg(ratio);
  u.angles.row(phi2) = unknowns.angles.row(phi4);
  u.angles.row(phi3).array() += pi;
  u.angles.row(phi4) = unknowns.angles.row(phi2);
  return normalised(u);
}

PathUnknowns cognate(const PathUnknowns& unknowns) {
  // A B P B' is a parallelogram, so AB' = BP and B'P = AB; B' P C' is similar to B P C the other
  // way round, and C' goes round the third pivot A + ratio (D - A).
  const auto& d = unknowns.dimensions;
  const Complex ratio = coupler_ratio(unknowns);
  const Complex pivot = Complex(d[xa], d[ya]) + ratio * Complex(d[xd] - d[xa], d[yd] - d[ya]);
  PathUnknowns u = unknowns;
  u.dimensions << d[xa], d[ya], pivot.real(), pivot.imag(), d[bp], std::abs(ratio) * d[ab],
      std::abs(ratio) * d[cd], d[ab], -std::arg(ratio);
  const double turn = std::arg(ratio);
  u.angles.row(phi2) = unknowns.angles.row(phi3).array() + d[alpha];
  u.angles.row(phi3) = unknowns.angles.row(phi2).array() + turn;
  u.angles.row(phi4) = unknowns.angles.row(phi4).array() + turn;
  return normalised(u);
}

FourBar linkage_of(const PathUnknowns& unknowns) {
  const auto& d = unknowns.dimensions;
  return {{d[xa], d[ya]}, {d[xd], d[yd]}, d[ab], d[bc], d[cd], d[bp], d[alpha]};
}

}  // namespace geneva::loads
