#include "fem/contact/sliding_search.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace geneva::fem {

namespace {

constexpr std::size_t most_steps = 8;
/// Of one step, so that what is extrapolated far does no harm.
constexpr double most_turn = 1.;

/// Between -pi and pi.
double wrapped(const double angle) { return std::remainder(angle, 2. * std::acos(-1.)); }

/// Pressure over the way that made it. The whole contact is softer than a node alone, and the way
/// counts what the bodies give way far from it: four times that is still on the side that settles,
/// in four fifths of the steps; with any factor it settles at the same directions.
double contact_stiffness(const ContactState& state) {
  double pressure = 0.;
  for (const double each : state.pressure) pressure = std::max(pressure, each);
  constexpr double local = 4.;
  return state.approach > 0. ? local * pressure / state.approach : 0.;
}

/// Whether most of the nodes that slip now did so then.
bool is_akin(const std::vector<bool>& then, const std::vector<bool>& now) {
  std::size_t both = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (then[i] && now[i]) ++both;
  return 2 * both > static_cast<std::size_t>(std::count(now.begin(), now.end(), true));
}

/// Solves the normal equations of the least squares of the weighted turns.
dealii::Vector<double> least_squares(dealii::FullMatrix<double> normal,
                                     const dealii::Vector<double>& right) {
  const auto n = static_cast<unsigned int>(normal.m());
  double trace = 0.;
  for (unsigned int i = 0; i < n; ++i) trace += normal(i, i);
  constexpr double regularisation = 1e-12;
  for (unsigned int i = 0; i < n; ++i) normal(i, i) += regularisation * trace;
  dealii::Vector<double> solution(n);
  if (trace == 0.) return solution;
  normal.gauss_jordan();
  normal.vmult(solution, right);
  return solution;
}

}  // namespace

double SlidingSearch::advance(const ContactInterface<3>& interface, const ContactState& state,
                              const std::vector<NodeStatus>& next,
                              std::vector<Components<3>>& sliding) {
  const std::size_t n = next.size();
  const double stiffness = contact_stiffness(state);
  Step step{std::vector<bool>(n), std::vector<double>(n), std::vector<double>(n)};
  std::vector<double> weight(n);
  double maximum = 0.;
  for (std::size_t i = 0; i < n; ++i) {
    const Components<3> from = interface.sliding_at(i);
    step.slips[i] = interface.status[i] == NodeStatus::slip && next[i] == NodeStatus::slip &&
                    (from[1] != 0. || from[2] != 0.);
    if (!step.slips[i]) continue;
    const Tangential before = interface.slip_before_at(i);
    const double bound = std::hypot(state.friction[i][0], state.friction[i][1]);
    step.angle[i] = std::atan2(from[2], from[1]);
    step.turn[i] =
        wrapped(std::atan2(bound * from[2] + stiffness * (state.slip[i][1] - before[1]),
                           bound * from[1] + stiffness * (state.slip[i][0] - before[0])) -
                step.angle[i]);
    weight[i] = bound * interface.rows[i].weight;
    maximum = std::max(maximum, std::abs(step.turn[i]));
  }
  while (!steps_.empty() &&
         (steps_.size() >= most_steps || !is_akin(steps_.front().slips, step.slips)))
    steps_.pop_front();
  steps_.push_back(std::move(step));
  const std::vector<double> more = extrapolated(weight);
  const Step& now = steps_.back();
  for (std::size_t i = 0; i < n; ++i) {
    if (!now.slips[i]) continue;
    const double angle = now.angle[i] + std::clamp(now.turn[i] + more[i], -most_turn, most_turn);
    sliding[i] = {0., std::cos(angle), std::sin(angle)};
  }
  return maximum;
}

std::vector<double> SlidingSearch::extrapolated(const std::vector<double>& weight) const {
  const Step& now = steps_.back();
  const std::size_t n = now.turn.size();
  std::vector<double> more(n, 0.);
  std::vector<bool> counts(n);
  for (std::size_t i = 0; i < n; ++i)
    counts[i] =
        std::all_of(steps_.begin(), steps_.end(), [i](const Step& s) { return s.slips[i]; });
  const auto m = static_cast<unsigned int>(steps_.size() - 1);
  if (m == 0) return more;
  const auto change = [&](const std::vector<double> Step::*of, const std::size_t k,
                          const std::size_t i) {
    return wrapped((steps_[k + 1].*of)[i] - (steps_[k].*of)[i]);
  };
  dealii::FullMatrix<double> normal(m, m);
  dealii::Vector<double> right(m);
  for (std::size_t i = 0; i < n; ++i) {
    if (!counts[i]) continue;
    for (unsigned int k = 0; k < m; ++k) {
      const double of_k = weight[i] * change(&Step::turn, k, i);
      right(k) += of_k * now.turn[i];
      for (unsigned int l = 0; l < m; ++l) normal(k, l) += of_k * change(&Step::turn, l, i);
    }
  }
  const dealii::Vector<double> share = least_squares(normal, right);
  for (std::size_t i = 0; i < n; ++i) {
    if (!counts[i]) continue;
    for (unsigned int k = 0; k < m; ++k)
      more[i] -= share(k) * (change(&Step::angle, k, i) + change(&Step::turn, k, i));
  }
  return more;
}

}  // namespace geneva::fem
