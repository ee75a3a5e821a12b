#include "loads/pin/section_search.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace geneva::loads {

namespace {

constexpr double first_load = 1e-6;  // of a section that is loaded anew, over the mean

}  // namespace

SectionSearch::SectionSearch(CoupledSections& sections, const double force,
                             const Eigen::VectorXd& start)
    : sections_(sections),
      n_(sections.size()),
      force_(force),
      mean_(force / sections.widths().sum()),
      loads_(start * (force / start.dot(sections.widths()))),
      displacements_(n_),
      system_(n_ + 1, n_ + 1),
      rest_(n_ + 1),
      step_(n_ + 1),
      factors_(n_ + 1) {
  sections_.choose_far(loads_.maxCoeff());
}

void SectionSearch::run() {
  constexpr int most_steps = 200;
  constexpr double enough = 1e-10;
  constexpr double settled = 1e-3;  // sections are added only then, or they come and go for ever
  double change = 1.;
  for (int i = 0; i < most_steps; ++i) {
    sections_.find_displacements(loads_, displacements_);
    if (change < settled && !load_overlapping() && change < enough) return;
    change = advance();
  }
  throw base::InputError("the line contacts along the pin find no balance");
}

/// One step of Newton.
/// @return greatest change of a line load over the greatest load
double SectionSearch::advance() {
  assemble();
  factors_.compute(system_);
  step_.noalias() = factors_.solve(rest_);
  double change = 0.;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const double before = loads_[i];
    if (before <= 0.) continue;
    loads_[i] = std::max(before + step_[i], 0.);
    change = std::max(change, std::abs(loads_[i] - before));
  }
  approach_ += step_[n_];
  return change / loads_.maxCoeff();
}

void SectionSearch::assemble() {
  system_.setZero();
  rest_.setZero();
  for (Eigen::Index i = 0; i < n_; ++i) {
    if (loads_[i] <= 0.) {
      system_(i, i) = 1.;
      continue;
    }
    for (Eigen::Index j = 0; j < n_; ++j)
      if (loads_[j] > 0.) system_(i, j) = sections_.tangent()(i, j);
    system_(i, n_) = -1.;
    system_(n_, i) = sections_.widths()[i];
    rest_[i] = approach_ - sections_.clearance()[i] - displacements_[i];
  }
  rest_[n_] = force_ - loads_.dot(sections_.widths());
}

/// Gives the sections that overlap a load.
/// @return whether there are any
bool SectionSearch::load_overlapping() {
  bool has_changed = false;
  for (Eigen::Index i = 0; i < n_; ++i)
    if (loads_[i] <= 0. && sections_.clearance()[i] + displacements_[i] < approach_) {
      loads_[i] = first_load * mean_;
      has_changed = true;
    }
  if (has_changed) sections_.find_displacements(loads_, displacements_);
  return has_changed;
}

}  // namespace geneva::loads
