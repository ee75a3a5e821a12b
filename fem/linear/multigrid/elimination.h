#pragma once

#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// Shares that an unknown has in others, ascending by these.
using Shares = std::vector<std::pair<int, double>>;

/// Constrained unknowns: u = E v.
class Elimination {
 public:
  /// An unknown of this rank.
  struct Line {
    std::size_t unknown;  ///< place among the rank's unknowns
    Shares shares;
  };

  /// @param unknowns of this rank
  /// @param lines by constrained unknowns of any rank, in unconstrained ones; those of this rank
  /// at least
  Elimination(const UnknownRanges& unknowns, const std::map<int, Shares>& lines);

  /// Those of this rank.
  [[nodiscard]] const std::vector<Line>& own() const { return own_; }
  /// What an unknown follows; none if it follows no other, or is not known here.
  [[nodiscard]] const Shares* shares_of(int unknown) const;
  /// The unknowns of other ranks that those of this rank follow, ascending.
  [[nodiscard]] std::vector<int> others() const;

  /// E v in place of v.
  void distribute(Vector& vector) const;
  /// E^T r in place of r; zero at the constrained unknowns.
  void collect(Vector& vector) const;
  /// The sums of the ranks' values, at this rank's unknowns.
  /// @param values at unknowns of any rank that this rank's follow
  [[nodiscard]] std::vector<double> sum(const std::map<int, double>& values) const;

 private:
  std::vector<Line> own_;
  std::unordered_map<int, Shares> lines_;  ///< of any rank
  NodePattern pattern_;                    ///< of the own lines
  std::vector<Shares> place_shares_;       ///< those of the own lines, by places in the pattern
};

}  // namespace geneva::fem
