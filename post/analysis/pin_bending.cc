#include "post/analysis/pin_bending.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "loads/pi.h"
#include "mesh/dense_algebra.h"

namespace geneva::post {

namespace {

/// Slices reach this share of the pin's diameter to either side.
constexpr double slice = 0.15;
/// The stress is fitted between these shares of the diameter from the root and followed to it: the
/// clamped face itself disturbs it.
constexpr double root_zone_begin = 0.25;
constexpr double root_zone_end = 1.25;

/// A weighted least-squares fit whose sums run over all ranks.
template <int n>
class Fit {
 public:
  using Row = Eigen::Matrix<double, n, 1>;

  void add(const double weight, const Row& row, const double value) {
    matrix_ += weight * row * row.transpose();
    right_ += weight * value * row;
  }

  [[nodiscard]] Row solve(const MPI_Comm communicator) const {
    std::vector<double> sums(matrix_.data(), matrix_.data() + matrix_.size());
    sums.insert(sums.end(), right_.data(), right_.data() + n);
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    const Eigen::Map<const Eigen::Matrix<double, n, n>> matrix(sums.data());
    const Eigen::Map<const Row> right(sums.data() + std::ptrdiff_t{n} * n);
    return mesh::least_squares(matrix, right);
  }

 private:
  Eigen::Matrix<double, n, n> matrix_ = Eigen::Matrix<double, n, n>::Zero();
  Row right_ = Row::Zero();
};

/// Displacement of the pin in a slice around z: mean along the force, and the cross-section's turn.
struct SliceMotion {
  double along_force;
  double turn;
};

class PinMotion {
 public:
  PinMotion(const fem::Solution<3>& solution, const PinPlace& pin)
      : solution_(solution), pin_(pin) {
    const auto& bodies = solution.problem.bodies;
    body_ = static_cast<unsigned int>(
        std::find_if(bodies.begin(), bodies.end(),
                     [&](const fem::Body<3>& body) { return body.name == pin.body; }) -
        bodies.begin());
  }

  /// Fits u = u0 + u' (z - z0) along the force and w = w0 + w' (z - z0) - (turn + turn' (z - z0))
  /// eta along the axis over a slice; with its image if z is a plane of symmetry. The primed terms
  /// keep a slice whose cells reach beyond it on one side from counting as its middle.
  [[nodiscard]] SliceMotion at(const double z, const double from, const double to,
                               const bool is_mirrored = false) const {
    const double length = solution_.scales.length;
    const dealii::FEValuesExtractors::Vector all(0);
    std::vector<dealii::Tensor<1, 3>> u;
    Fit<2> along;
    Fit<4> axial;
    for_each_cell(from, to, [&](const dealii::FEValues<3>& values) {
      u.resize(values.n_quadrature_points);
      values[all].get_function_values(solution_.displacement, u);
      for (unsigned int q = 0; q < u.size(); ++q) {
        const dealii::Point<3> x = length * values.quadrature_point(q);
        if (x[2] < from || x[2] > to) continue;
        const double zeta = (x[2] - z) / pin_.diameter;
        const double across = eta(x) / pin_.diameter;
        const auto add = [&](const double place, const double w) {
          along.add(values.JxW(q), {1., place}, along_force(u[q]) * length);
          axial.add(values.JxW(q), {1., place, across, place * across}, w);
        };
        add(zeta, u[q][2] * length);
        if (is_mirrored) add(-zeta, -u[q][2] * length);
      }
    });
    const MPI_Comm communicator = solution_.dof_handler->get_communicator();
    return {along.solve(communicator)(0), axial.solve(communicator)(2) / pin_.diameter};
  }

  /// Second moment of area of the cross-section as meshed, the mean over a slice [m^4].
  [[nodiscard]] double second_moment(const double from, const double to) const {
    const double length = solution_.scales.length;
    double moment = 0.;
    for_each_cell(from, to, [&](const dealii::FEValues<3>& values) {
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
        const dealii::Point<3> x = length * values.quadrature_point(q);
        if (x[2] < from || x[2] > to) continue;
        moment += std::pow(length, 3) * values.JxW(q) * eta(x) * eta(x);
      }
    });
    return dealii::Utilities::MPI::sum(moment, solution_.dof_handler->get_communicator()) /
           (to - from);
  }

  /// Distance from the pin's axis along the force.
  [[nodiscard]] double eta(const dealii::Point<3>& x) const {
    return (x[0] - pin_.x) * pin_.direction[0] + (x[1] - pin_.y) * pin_.direction[1];
  }
  [[nodiscard]] unsigned int body() const { return body_; }

 private:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;
  /// Numbers of points along the reference directions of a cell; 0: the cell does not rise along
  /// it.
  using Points = std::array<unsigned int, 3>;

  /// Where the cell rises along the pin, more points than the slice needs.
  [[nodiscard]] Points points_in(const Cell& cell, const double thickness) const {
    constexpr double level = 1e-6;
    constexpr unsigned int most_points = 16;
    const double length = solution_.scales.length;
    Points points{};
    for (unsigned int k = 0; k < 3; ++k) {
      double rise = 0.;
      for (unsigned int vertex = 0; vertex < 8; ++vertex)
        if ((vertex >> k & 1U) == 0)
          rise =
              std::max(rise, std::abs(cell->vertex(vertex | 1U << k)[2] - cell->vertex(vertex)[2]));
      if (rise > level * cell->diameter())
        points[k] = std::clamp(static_cast<unsigned int>(std::ceil(4. * rise * length / thickness)),
                               2U, most_points);
    }
    return points;
  }

  /// Gauss's points, or evenly spaced ones, each for the same share of its cell.
  static dealii::Quadrature<3> quadrature_of(const Points& points) {
    const auto along = [](const unsigned int n) -> dealii::Quadrature<1> {
      if (n == 0) return dealii::QGauss<1>(2);
      return dealii::QIterated<1>(dealii::QMidpoint<1>(), n);
    };
    return dealii::QAnisotropic<3>(along(points[0]), along(points[1]), along(points[2]));
  }

  /// Calls f with the evaluation of each cell of the pin that reaches into a slice.
  template <typename F>
  void for_each_cell(const double from, const double to, const F& f) const {
    const double length = solution_.scales.length;
    std::map<Points, dealii::FEValues<3>> values_by_points;
    for (const auto& cell : solution_.dof_handler->active_cell_iterators()) {
      if (!cell->is_locally_owned() || cell->material_id() != body_) continue;
      const double middle = cell->center()[2] * length;
      const double size = cell->diameter() * length;
      if (middle + size < from || middle - size > to) continue;
      const Points points = points_in(cell, to - from);
      dealii::FEValues<3>& values =
          values_by_points
              .try_emplace(points, *solution_.element, quadrature_of(points),
                           dealii::update_values | dealii::update_quadrature_points |
                               dealii::update_JxW_values)
              .first->second;
      values.reinit(cell);
      f(values);
    }
  }

  [[nodiscard]] double along_force(const dealii::Tensor<1, 3>& u) const {
    return u[0] * pin_.direction[0] + u[1] * pin_.direction[1];
  }

  const fem::Solution<3>& solution_;
  const PinPlace& pin_;
  unsigned int body_;
};

/// sigma_zz = (c0 + c1 (root - z)) eta near the root: c0 d/2 is the stress at its outermost point.
/// A short pin is fitted as far as the middle of the wheel.
double root_stress(const fem::Solution<3>& solution, const PinPlace& pin, const PinMotion& motion,
                   const std::vector<CellStress<3>>& cells) {
  const double length = std::max(pin.free_length, 0.5 * (pin.root - pin.middle));
  const double reach = std::min(root_zone_end * pin.diameter, length);
  const double begin = root_zone_begin / root_zone_end * reach;
  Fit<2> fit;
  for (const CellStress<3>& cell : cells) {
    const double inwards = pin.root - cell.centre[2];
    if (cell.body != motion.body() || inwards < begin || inwards > reach) continue;
    const double eta = motion.eta(cell.centre) / pin.diameter;
    fit.add(cell.measure / std::pow(pin.diameter, 3), {eta, eta * inwards / pin.diameter},
            cell.stress[2][2]);
  }
  return std::abs(fit.solve(solution.dof_handler->get_communicator())(0)) / 2.;
}

/// 32 M/(pi d^3) for the moment that the holder exerts about the middle of the root face.
double stress_of_reaction(const fem::Solution<3>& solution, const PinPlace& pin) {
  const auto reaction = std::find_if(
      solution.reactions.begin(), solution.reactions.end(),
      [&](const fem::Reaction<3>& candidate) { return candidate.surface == pin.root_surface; });
  const dealii::Tensor<1, 3> arm({pin.x, pin.y, pin.root});
  const dealii::Tensor<1, 3> force({reaction->force[0], reaction->force[1], reaction->force[2]});
  const dealii::Tensor<1, 3> moment = reaction->moment - dealii::cross_product_3d(arm, force);
  return 32. * std::hypot(moment[0], moment[1]) / (loads::pi * std::pow(pin.diameter, 3));
}

}  // namespace

PinBending pin_bending(const fem::Solution<3>& solution, const PinPlace& pin,
                       const std::vector<CellStress<3>>& cells) {
  const bool is_short = pin.free_length < 0.5 * pin.diameter;
  const PinMotion motion(solution, pin);
  const double reach = slice * pin.diameter;
  const SliceMotion tip = motion.at(pin.tip, pin.tip - reach, pin.tip + reach, pin.is_half);
  const SliceMotion root = motion.at(pin.root, pin.root - reach, pin.root);
  const SliceMotion middle =
      motion.at(pin.middle, pin.middle - reach, pin.middle + reach, pin.is_half);
  // Where the moment is greatest and the cells are coarse.
  const double section =
      motion.second_moment(pin.root - std::max(pin.free_length, reach), pin.root);
  return {std::abs(tip.along_force - root.along_force), std::abs(middle.turn),
          is_short && !pin.held_at_both_ends ? stress_of_reaction(solution, pin)
                                             : root_stress(solution, pin, motion, cells),
          section / (loads::pi * std::pow(pin.diameter, 4) / 64.)};
}

}  // namespace geneva::post
