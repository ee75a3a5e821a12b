#include "fem/linear/multigrid/elimination.h"

namespace geneva::fem {

namespace {

std::vector<Elimination::Line> lines_of(const UnknownRanges& unknowns,
                                        const std::map<int, Shares>& lines) {
  std::vector<Elimination::Line> own;
  for (const auto& [unknown, shares] : lines)
    if (unknowns.have(unknown))
      own.push_back({static_cast<std::size_t>(unknown - unknowns.first()), shares});
  return own;
}

NodePattern pattern_of(const UnknownRanges& unknowns, const std::vector<Elimination::Line>& lines) {
  std::vector<std::vector<int>> coupled;
  for (const Elimination::Line& line : lines) {
    coupled.emplace_back();
    for (const auto& share : line.shares) coupled.back().push_back(share.first);
  }
  return {unknowns, 1, coupled};
}

}  // namespace

Elimination::Elimination(const UnknownRanges& unknowns, const std::map<int, Shares>& lines)
    : own_(lines_of(unknowns, lines)),
      lines_(lines.begin(), lines.end()),
      pattern_(pattern_of(unknowns, own_)) {
  for (const Line& line : own_) {
    place_shares_.push_back(line.shares);
    for (auto& share : place_shares_.back()) share.first = pattern_.place_of(share.first);
  }
}

const Shares* Elimination::shares_of(const int unknown) const {
  const auto found = lines_.find(unknown);
  return found == lines_.end() ? nullptr : &found->second;
}

std::vector<int> Elimination::others() const {
  return {pattern_.numbers().begin() + static_cast<std::ptrdiff_t>(pattern_.own().size()),
          pattern_.numbers().end()};
}

void Elimination::distribute(Vector& vector) const {
  double* const own = vector.begin();
  const double* const others = pattern_.on_others(own);
  const auto n_own = static_cast<int>(pattern_.own().size());
  for (std::size_t i = 0; i < own_.size(); ++i) {
    double value = 0.;
    for (const auto& [place, share] : place_shares_[i])
      value += share * (place < n_own ? own[place] : others[place - n_own]);
    own[own_[i].unknown] = value;
  }
}

void Elimination::collect(Vector& vector) const {
  const auto n_own = static_cast<int>(pattern_.own().size());
  double* const values = vector.begin();
  pattern_.add(
      values,
      [&](double* const others) {
        for (std::size_t i = 0; i < own_.size(); ++i)
          for (const auto& [place, share] : place_shares_[i])
            if (place >= n_own) others[place - n_own] += share * values[own_[i].unknown];
      },
      [&](double* const own) {
        for (std::size_t i = 0; i < own_.size(); ++i)
          for (const auto& [place, share] : place_shares_[i])
            if (place < n_own) own[place] += share * values[own_[i].unknown];
        for (const Line& line : own_) values[line.unknown] = 0.;
      });
}

std::vector<double> Elimination::sum(const std::map<int, double>& values) const {
  const auto n_own = static_cast<int>(pattern_.own().size());
  std::vector<double> sums(pattern_.own().size(), 0.);
  const auto visit = [&](const auto& add) {
    for (const auto& [unknown, value] : values) add(pattern_.place_of(unknown), value);
  };
  pattern_.add(
      sums.data(),
      [&](double* const others) {
        visit([&](const int place, const double value) {
          if (place >= n_own) others[place - n_own] += value;
        });
      },
      [&](double* const own) {
        visit([&](const int place, const double value) {
          if (place < n_own) own[place] += value;
        });
      });
  return sums;
}

}  // namespace geneva::fem
