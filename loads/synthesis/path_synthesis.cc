#include "loads/synthesis/path_synthesis.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <random>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"
#include "loads/synthesis/path_newton.h"

namespace geneva::loads {

namespace {

using Complex = std::complex<double>;
using Dimensions = Eigen::Matrix<double, 9, 1>;

constexpr std::array<const char*, 9> names = {"X_A", "Y_A", "X_D", "Y_D",  "AB",
                                              "BC",  "CD",  "BP",  "alpha"};
constexpr int most_iterations = 80;  // more starts find more than longer ones

/// The task in units of the points' extent about their mean.
struct Scaled {
  Eigen::Vector2d centre;
  double extent;  // maximum distance of two points [m]
  Eigen::Matrix2Xd points;
  std::array<std::optional<double>, 9> given;
  std::vector<Eigen::Index> free;
};

void check_points(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 2 || points.size() > 9)
    throw base::InputError(
        fmt::format("number of points is {}: a four-bar linkage can be made to pass 2 to 9; give a "
                    "number in this range",
                    points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    require_finite("X of a point", 1e3 * points[i][0], "mm");
    require_finite("Y of a point", 1e3 * points[i][1], "mm");
    for (std::size_t j = 0; j < i; ++j)
      if (points[i] == points[j])
        throw base::InputError(
            fmt::format("points {} and {} are both ({:.6g}, {:.6g}) mm: all points must differ; "
                        "leave one out and give one more dimension",
                        j + 1, i + 1, 1e3 * points[i][0], 1e3 * points[i][1]));
  }
}

void check_given(const PathTask& task) {
  const std::size_t wanted = 9 - task.points.size();
  if (task.given.size() != wanted)
    throw base::InputError(fmt::format(
        "{} dimensions are given with {} points: exactly {} of X_A, Y_A, X_D, Y_D, AB, BC, CD, BP "
        "and alpha must be given, 9 less the number of points; give {} {}",
        task.given.size(), task.points.size(), wanted,
        task.given.size() < wanted ? wanted - task.given.size() : task.given.size() - wanted,
        task.given.size() < wanted ? "more" : "fewer"));
  std::array<bool, 9> seen{};
  for (const auto& [dimension, value] : task.given) {
    const auto k = static_cast<std::size_t>(dimension);
    if (seen[k])
      throw base::InputError(fmt::format(
          "{} is given twice: each dimension may be given once; give another one", names[k]));
    seen[k] = true;
    if (k == 8)
      require_finite(names[k], value * 180. / pi, "deg");
    else if (k < 4)
      require_finite(names[k], 1e3 * value, "mm");
    else
      require_positive_length(names[k], value);
  }
}

Dimensions scaled_dimensions(const Dimensions& d, const Eigen::Vector2d& centre, double extent) {
  Dimensions s = d / extent;
  s.head<4>() -= centre.replicate<2, 1>() / extent;
  s[8] = d[8];
  return s;
}

Scaled scale(const PathTask& task) {
  const auto count = static_cast<Eigen::Index>(task.points.size());
  Scaled s{
      {}, 0., Eigen::Map<const Eigen::Matrix2Xd>(task.points.front().data(), 2, count), {}, {}};
  s.centre = s.points.rowwise().mean();
  s.points.colwise() -= s.centre;
  for (Eigen::Index i = 0; i < count; ++i)
    s.extent =
        std::max(s.extent, (s.points.colwise() - s.points.col(i)).colwise().norm().maxCoeff());
  s.points /= s.extent;
  for (const auto& [dimension, value] : task.given) {
    const auto k = static_cast<std::size_t>(dimension);
    s.given[k] = scaled_dimensions(Dimensions::Constant(value), s.centre,
                                   s.extent)[static_cast<Eigen::Index>(k)];
  }
  for (std::size_t k = 0; k < 9; ++k)
    if (!s.given[k]) s.free.push_back(static_cast<Eigen::Index>(k));
  return s;
}

/// Uniform random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  double sign() { return between(-1., 1.) < 0. ? -1. : 1.; }

 private:
  std::mt19937_64 engine_;
};

Complex complex(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

/// Closes A B P at a point, or comes as near as it can, and points the rocker from D to C.
/// @returns how much longer than CD the distance of C and D is
double close_at_point(PathUnknowns& u, Eigen::Index i, const Eigen::Vector2d& point, double elbow) {
  const auto& d = u.dimensions;
  const Complex crank_pivot(d[0], d[1]);
  const Complex to_point = complex(point) - crank_pivot;
  const double distance = std::abs(to_point);
  const double cosine = (d[4] * d[4] + distance * distance - d[7] * d[7]) / (2. * d[4] * distance);
  u.angles(0, i) = std::arg(to_point) + elbow * std::acos(std::clamp(cosine, -1., 1.));
  const Complex pin = crank_pivot + std::polar(d[4], u.angles(0, i));
  u.angles(1, i) = std::arg(complex(point) - pin) - d[8];
  const Complex rocker = pin + std::polar(d[5], u.angles(1, i)) - Complex(d[2], d[3]);
  u.angles(2, i) = std::arg(rocker);
  return std::abs(rocker) - d[6];
}

/// D and CD of the circle that fits the places of C best (least squares of |C|^2 - 2 C D - k).
void fit_rocker(PathUnknowns& u) {
  const Eigen::Index count = u.angles.cols();
  Eigen::MatrixX3d matrix(count, 3);
  Eigen::VectorXd squares(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& d = u.dimensions;
    const Complex joint =
        Complex(d[0], d[1]) + std::polar(d[4], u.angles(0, i)) + std::polar(d[5], u.angles(1, i));
    matrix.row(i) << 2. * joint.real(), 2. * joint.imag(), 1.;
    squares[i] = std::norm(joint);
  }
  const Eigen::Vector3d fit =
      (matrix.transpose() * matrix).ldlt().solve(matrix.transpose() * squares);
  u.dimensions.segment<2>(2) = fit.head<2>();
  u.dimensions[6] = std::sqrt(std::max(1e-6, fit[2] + fit.head<2>().squaredNorm()));
}

/// Draws the dimensions that are not given; lengths of the dyad A B P so that it reaches all points
/// if that can be had in a few attempts.
Dimensions draw_dimensions(const Scaled& task, Random& random) {
  constexpr int attempts = 50;
  Dimensions d;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Complex crank_pivot = std::polar(random.between(0., 2.), random.between(-pi, pi));
    const Complex rocker_pivot = std::polar(random.between(0., 2.), random.between(-pi, pi));
    d << crank_pivot.real(), crank_pivot.imag(), rocker_pivot.real(), rocker_pivot.imag(), 0.,
        random.log_between(0.1, 2.), random.log_between(0.1, 2.), 0., random.between(-pi, pi);
    for (Eigen::Index k = 0; k < 4; ++k)
      d[k] = task.given[static_cast<std::size_t>(k)].value_or(d[k]);
    const Eigen::VectorXd reach = (task.points.colwise() - d.head<2>()).colwise().norm();
    const double middle = (reach.maxCoeff() + reach.minCoeff()) / 2.;
    const double half = std::max(0.05, (reach.maxCoeff() - reach.minCoeff()) / 2.);
    const double short_link =
        half * std::exp(1.5 * random.between(0., 1.) * random.between(0., 1.));
    const double long_link = middle * std::exp(random.between(-0.3, 0.5));
    const bool short_crank = random.between(0., 1.) < 0.75;
    d[4] = short_crank ? short_link : long_link;
    d[7] = short_crank ? long_link : short_link;
    for (Eigen::Index k = 4; k < 9; ++k)
      d[k] = task.given[static_cast<std::size_t>(k)].value_or(d[k]);
    if (d[4] + d[7] >= reach.maxCoeff() && std::abs(d[4] - d[7]) <= reach.minCoeff()) break;
  }
  return d;
}

/// Closes all points and takes for D and CD, as far as they are free, what suits the places of C.
PathUnknowns random_start(const Scaled& task, Random& random) {
  constexpr double maximum_rocker = 10.;
  PathUnknowns u{draw_dimensions(task, random), Eigen::Matrix3Xd(3, task.points.cols())};
  const double elbow = random.sign();
  const auto close = [&] {
    double excess = 0.;
    for (Eigen::Index i = 0; i < task.points.cols(); ++i)
      excess += close_at_point(u, i, task.points.col(i), elbow);
    return excess / static_cast<double>(task.points.cols());
  };
  const double mean_excess = close();
  if (task.given[6]) return u;
  const Dimensions drawn = u.dimensions;
  if (task.points.cols() > 2 && !task.given[2] && !task.given[3])
    fit_rocker(u);
  else
    u.dimensions[6] += mean_excess;
  if (!(u.dimensions[6] < maximum_rocker)) u.dimensions = drawn;  // C nearly on a straight line
  close();
  return u;
}

/// Start at a given linkage: at every point the elbow that closes the rocker better.
PathUnknowns start_at(const FourBar& guess, const Scaled& task) {
  Dimensions d;
  d << guess.crank_pivot[0], guess.crank_pivot[1], guess.rocker_pivot[0], guess.rocker_pivot[1],
      guess.crank, guess.coupler, guess.rocker, guess.point_distance, guess.point_angle;
  PathUnknowns u{scaled_dimensions(d, task.centre, task.extent),
                 Eigen::Matrix3Xd(3, task.points.cols())};
  for (Eigen::Index k = 0; k < 9; ++k)
    u.dimensions[k] = task.given[static_cast<std::size_t>(k)].value_or(u.dimensions[k]);
  for (Eigen::Index i = 0; i < task.points.cols(); ++i) {
    const double one = close_at_point(u, i, task.points.col(i), 1.);
    const Eigen::Vector3d angles = u.angles.col(i);
    const double other = close_at_point(u, i, task.points.col(i), -1.);
    if (std::abs(one) < std::abs(other)) u.angles.col(i) = angles;
  }
  return u;
}

/// Both in normal form.
bool same_linkage(const Dimensions& one, const Dimensions& other) {
  constexpr double tolerance = 1e-6;  // of the extent; different solutions differ by far more
  const double turn = std::remainder(one[8] - other[8], 2. * pi) * one[7];
  return (one.head<8>() - other.head<8>()).cwiseAbs().maxCoeff() < tolerance * (1. + one[7]) &&
         std::abs(turn) < tolerance * (1. + one[7]);
}

/// A length that came out negative turns alpha by pi: another linkage than the one asked for if
/// alpha is given.
bool keeps_given_angle(const Dimensions& d, const Scaled& task) {
  return !task.given[8] || std::abs(std::remainder(d[8] - *task.given[8], 2. * pi)) < 1.;
}

struct Found {
  PathUnknowns unknowns;
  int iterations;
};

void add(const PathUnknowns& unknowns, int iterations, std::vector<Found>& found) {
  if (!is_proper(unknowns.dimensions)) return;
  for (const Found& known : found)
    if (same_linkage(known.unknowns.dimensions, unknowns.dimensions)) return;
  found.push_back({unknowns, iterations});
}

/// Adds the linkage, and if all dimensions are free the other five generators of its curve, each
/// brought to the level of rounding by a few steps of its own.
void add_family(const Scaled& task, const NewtonEnd& end, std::vector<Found>& found) {
  constexpr int polish = 5;
  PathUnknowns member = normalised(end.unknowns);
  if (!keeps_given_angle(member.dimensions, task)) return;
  add(member, end.iterations, found);
  if (task.free.size() < 9) return;
  for (int k = 1; k < 6; ++k) {
    member = k % 2 == 1 ? with_rocker_as_crank(member) : cognate(member);
    const NewtonEnd polished = solve_path(task.points, task.free, member, polish);
    if (!polished.converged) return;
    member = normalised(polished.unknowns);
    add(member, end.iterations, found);
  }
}

std::vector<Found> search(const PathTask& task, const Scaled& scaled, PathSynthesis& result) {
  Random random(task.seed);
  std::vector<Found> found;
  const int guesses = static_cast<int>(task.guesses.size());
  for (result.starts = 0; result.starts < guesses + task.starts; ++result.starts) {
    const PathUnknowns start =
        result.starts < guesses
            ? start_at(task.guesses[static_cast<std::size_t>(result.starts)], scaled)
            : random_start(scaled, random);
    const NewtonEnd end = solve_path(scaled.points, scaled.free, start, most_iterations);
    result.minimum_residual =
        std::min(result.minimum_residual, end.minimum_residual * scaled.extent);
    if (!end.converged) continue;
    if (is_proper(end.unknowns.dimensions))
      add_family(scaled, end, found);
    else
      ++result.degenerate;
  }
  return found;
}

/// Index of the crank's range that holds the angle and the angle within it, counted from its start.
std::pair<std::size_t, double> place_in_ranges(const std::vector<std::pair<double, double>>& ranges,
                                               double angle) {
  constexpr double slack = 1e-6;  // a limit may be a point: its angle is known to sqrt(rounding)
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    double within = std::fmod(angle - ranges[k].first, 2. * pi);
    if (within < 0.) within += 2. * pi;
    if (within > 2. * pi - slack) within -= 2. * pi;
    if (within <= ranges[k].second - ranges[k].first + slack) return {k, within};
  }
  return {ranges.size(), 0.};
}

/// All differences in one sense, and together less than a turn where the crank turns fully.
bool in_order(const std::vector<double>& angles, bool full_turn) {
  const auto passes = [&](double sense) {
    double sum = 0.;
    for (std::size_t i = 1; i < angles.size(); ++i) {
      double step = sense * (angles[i] - angles[i - 1]);
      if (full_turn) step -= 2. * pi * std::floor(step / (2. * pi));
      if (step <= 0.) return false;
      sum += step;
    }
    return sum < 2. * pi;
  };
  return passes(1.) || passes(-1.);
}

Assembly assembly_at(const PathUnknowns& u, Eigen::Index i) {
  const auto& d = u.dimensions;
  const Complex pin = Complex(d[0], d[1]) + std::polar(d[4], u.angles(0, i));
  const Complex to_pivot = Complex(d[2], d[3]) - pin;
  const Complex turned = std::conj(to_pivot) * std::polar(1., u.angles(1, i));
  return turned.imag() > 0. ? Assembly::open : Assembly::crossed;
}

PathSolution judged(const Found& found, const Scaled& task) {
  PathUnknowns u = found.unknowns;
  u.dimensions.head<8>() *= task.extent;
  u.dimensions.head<4>() += task.centre.replicate<2, 1>();
  const Eigen::Matrix2Xd points = (task.extent * task.points).colwise() + task.centre;
  PathSolution s{linkage_of(u),    {},    {},   path_residual(u, points).cwiseAbs().maxCoeff(),
                 found.iterations, false, false};
  const auto ranges = crank_ranges(s.linkage);
  std::vector<double> within;
  std::vector<std::size_t> range;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    s.crank_angles.push_back(u.angles(0, i));
    s.assemblies.push_back(assembly_at(u, i));
    const auto place = place_in_ranges(ranges, u.angles(0, i));
    range.push_back(place.first);
    within.push_back(place.second);
    s.needs_reassembly |=
        s.assemblies.back() != s.assemblies.front() || range.back() != range.front();
  }
  const bool full_turn = crank_turns_fully(s.linkage);
  s.out_of_order = !in_order(ranges.size() == 1 ? within : s.crank_angles, full_turn);
  return s;
}

}  // namespace

PathSynthesis synthesise_path(const PathTask& task) {
  check_points(task.points);
  check_given(task);
  require_not_negative("number of starts", task.starts, "");
  for (const FourBar& guess : task.guesses) check(guess);
  const Scaled scaled = scale(task);
  PathSynthesis result{{}, INFINITY, 0, 0};
  for (const Found& found : search(task, scaled, result))
    result.solutions.push_back(judged(found, scaled));
  const auto defects = [](const PathSolution& s) {
    return (s.needs_reassembly ? 2 : 0) + (s.out_of_order ? 1 : 0);
  };
  const auto longest = [](const PathSolution& s) {
    return std::max(
        {s.linkage.crank, s.linkage.coupler, s.linkage.rocker, frame_length(s.linkage)});
  };
  std::stable_sort(result.solutions.begin(), result.solutions.end(),
                   [&](const PathSolution& a, const PathSolution& b) {
                     return std::make_pair(defects(a), longest(a)) <
                            std::make_pair(defects(b), longest(b));
                   });
  return result;
}

}  // namespace geneva::loads
