#include "loads/pin/strip_influence.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "loads/pi.h"

namespace geneva::loads {

namespace {

constexpr double most_tabled = 3.;           // from here on by powers of 1/s
constexpr double least_tabled = 1. / 4096.;  // up to here by (4/pi) s ln(4/s)

/// K - E of a modulus, by the arithmetic-geometric mean (Abramowitz and Stegun 1964, 17.6).
/// @param complement complementary modulus, 0 < k' <= 1
double first_less_second_kind(const double complement) {
  double a = 1.;
  double b = complement;
  double sum = (1. - complement * complement) / 2.;
  double power = 1.;
  while (std::abs(a - b) > 1e-9 * a) {
    const double c = (a - b) / 2.;
    const double mean = (a + b) / 2.;
    b = std::sqrt(a * b);
    a = mean;
    sum += power * c * c;
    power *= 2.;
  }
  return pi / (2. * a) * sum;
}

double exact_derivative(const double s) {
  const double root = std::hypot(1., s);
  return 4. / pi * root * first_less_second_kind(s / root);
}

/// A(s) = ln(4 s) + 1/2 - sum_m (-1)^m W_m^2/(2 m (m + 1)) s^(-2 m), W_m = (2 m)!/(4^m m!^2).
StripInfluence far_influence(const double s) {
  constexpr int n_powers = 9;
  StripInfluence result{std::log(4. * s) + 0.5, 1. / s};
  const double inverse_square = 1. / (s * s);
  double ratio = 1.;
  double power = 1.;
  for (int m = 1; m <= n_powers; ++m) {
    ratio *= (2. * m - 1.) / (2. * m);
    power *= -inverse_square;
    const double term = ratio * ratio / (2. * m * (m + 1.)) * power;
    result.value -= term;
    result.derivative += 2. * m * term / s;
  }
  return result;
}

StripInfluence near_influence(const double s) {
  if (s == 0.) return {0., 0.};
  const double logarithm = std::log(4. / s);
  return {4. / pi * s * logarithm, 4. / pi * (logarithm - 1.)};
}

/// Values in between, even in u = ln s.
class Table {
 public:
  Table() {
    entries_.back() = {far_influence(most_tabled).value,
                       exact_derivative(most_tabled) * most_tabled};
    for (std::size_t i = n_steps; i-- > 0;) {
      const double u = first_ + static_cast<double>(i) * step_;
      entries_[i] = {entries_[i + 1].value - increase(u),
                     exact_derivative(std::exp(u)) * std::exp(u)};
    }
  }

  /// By cubics with the right slopes.
  [[nodiscard]] StripInfluence at(const double s) const {
    const double place = (std::log(s) - first_) / step_;
    const auto i = static_cast<std::size_t>(place);
    const double x = place - static_cast<double>(i);
    const Entry& a = entries_[i];
    const Entry& b = entries_[i + 1];
    const double rise = b.value - a.value;
    const double curve = step_ * (a.slope + b.slope) - 2. * rise;
    const double lower = step_ * a.slope;
    const double bend = 3. * rise - step_ * (2. * a.slope + b.slope);
    return {a.value + x * (lower + x * (bend + x * curve)),
            (lower + x * (2. * bend + 3. * x * curve)) / (step_ * s)};
  }

 private:
  struct Entry {
    double value;
    double slope;  ///< dA/du
  };
  static constexpr std::size_t n_steps = 400;

  /// Of A over a step, by three points of Gauss.
  [[nodiscard]] double increase(const double u) const {
    const double half = step_ / 2.;
    const double off = half * std::sqrt(0.6);
    const auto slope = [](const double at) {
      return exact_derivative(std::exp(at)) * std::exp(at);
    };
    return half / 9. *
           (5. * slope(u + half - off) + 8. * slope(u + half) + 5. * slope(u + half + off));
  }

  double first_ = std::log(least_tabled);
  double step_ = (std::log(most_tabled) - first_) / n_steps;
  std::array<Entry, n_steps + 1> entries_{};
};

}  // namespace

StripInfluence strip_influence(const double s) {
  static const Table table;
  const double size = std::abs(s);
  const StripInfluence result = size < least_tabled  ? near_influence(size)
                                : size < most_tabled ? table.at(size)
                                                     : far_influence(size);
  return {s < 0. ? -result.value : result.value, result.derivative};
}

}  // namespace geneva::loads
